#include "geometry/elementQuadrature.hpp"

#include "geometry/PatchQuadrature.hpp"
#include "geometry/triangleRule.hpp"

namespace tokay::geometry {

std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree) {
    QuadratureOptions options;
    options.degree = degree;
    return PatchQuadrature(patch, options).points(element);
}

void appendCellQuadrature(const Polygon& part, int degree, std::vector<ParameterPoint>& points) {
    const TriangleRule& rule = triangleRule(degree);
    for (std::size_t i = 1; i + 1 < part.size(); ++i) {
        const Parameters &a = part[0], toB = part[i] - a, toC = part[i + 1] - a;
        const double area = 0.5 * (toB[0] * toC[1] - toB[1] * toC[0]);
        if (area == 0)
            continue;
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Parameters place = a + rule.points[k][1] * toB + rule.points[k][2] * toC;
            points.push_back({place[0], place[1], area * rule.weights[k]});
        }
    }
}

} // namespace tokay::geometry
