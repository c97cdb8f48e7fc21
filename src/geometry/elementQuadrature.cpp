#include "geometry/elementQuadrature.hpp"

#include "geometry/gaussLegendre.hpp"
#include "geometry/triangleRule.hpp"

namespace tokay::geometry {

namespace {

std::vector<ParameterPoint> tensorRule(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper,
                                       int degree) {
    const QuadratureRule& rule = gaussLegendre(degree / 2 + 1);
    const Eigen::Vector2d size = upper - lower;
    std::vector<ParameterPoint> points;
    for (std::size_t j = 0; j < rule.points.size(); ++j)
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            points.push_back({lower[0] + size[0] * rule.points[i],
                              lower[1] + size[1] * rule.points[j],
                              size[0] * size[1] * rule.weights[i] * rule.weights[j]});
    return points;
}

} // namespace

std::vector<ParameterPoint> cellQuadrature(const std::vector<Polygon>& parts, int degree) {
    const TriangleRule& rule = triangleRule(degree);
    std::vector<ParameterPoint> points;
    for (const Polygon& part : parts)
        for (std::size_t i = 1; i + 1 < part.size(); ++i) {
            const double area = signedArea({part[0], part[i], part[i + 1]});
            if (area == 0)
                continue;
            for (std::size_t k = 0; k < rule.points.size(); ++k) {
                const Barycentric& b = rule.points[k];
                const Eigen::Vector2d x = b[0] * part[0] + b[1] * part[i] + b[2] * part[i + 1];
                points.push_back({x[0], x[1], area * rule.weights[k]});
            }
        }
    return points;
}

std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree) {
    const Eigen::Vector2d lower = patch.elementLower(element), upper = patch.elementUpper(element);
    switch (patch.state(element)) {
    case ElementState::empty:
        return {};
    case ElementState::full:
        return tensorRule(lower, upper, degree);
    case ElementState::cut:
        break;
    }
    const Polygon cell = {lower, {upper[0], lower[1]}, upper, {lower[0], upper[1]}};
    return cellQuadrature(patch.clipped(cell), degree);
}

} // namespace tokay::geometry
