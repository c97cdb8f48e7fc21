#include "geometry/elementQuadrature.hpp"

#include "geometry/PatchQuadrature.hpp"
#include "geometry/triangleRule.hpp"

namespace tokay::geometry {

std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree) {
    QuadratureOptions options;
    options.degree = degree;
    return PatchQuadrature(patch, options).points(element);
}

std::vector<ParameterPoint> cellQuadrature(const std::vector<Polygon>& parts, int degree) {
    const TriangleRule& rule = triangleRule(degree);
    std::vector<ParameterPoint> points;
    for (const Polygon& part : parts)
        for (std::size_t i = 1; i + 1 < part.size(); ++i) {
            const Parameters &a = part[0], &b = part[i], &c = part[i + 1];
            const double area = signedArea({a, b, c});
            if (area == 0)
                continue;
            for (std::size_t k = 0; k < rule.points.size(); ++k) {
                const Barycentric& at = rule.points[k];
                const Parameters place = at[0] * a + at[1] * b + at[2] * c;
                points.push_back({place[0], place[1], area * rule.weights[k]});
            }
        }
    return points;
}

} // namespace tokay::geometry
