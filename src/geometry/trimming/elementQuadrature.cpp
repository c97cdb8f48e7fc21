// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/elementQuadrature.hpp"

#include "geometry/quadrature/triangleRule.hpp"
#include "geometry/trimming/PatchQuadrature.hpp"

#include <algorithm>

namespace tokay::geometry {

std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree) {
    QuadratureOptions options;
    options.degree = degree;
    return PatchQuadrature(patch, options).points(element);
}

namespace {

/// The corner that the polygon is cut from. The lowest one in an odd direction: so the
/// points do not depend on the order of corners, nor, along knot lines, on rounding.
std::size_t firstCorner(const Polygon& polygon) {
    const auto lowest = std::min_element(polygon.begin(), polygon.end(),
                                         [](const Parameters& a, const Parameters& b) {
                                             const Parameters direction(0.87, 0.49);
                                             return direction.dot(a) < direction.dot(b);
                                         });
    return static_cast<std::size_t>(lowest - polygon.begin());
}

} // namespace

void appendCellQuadrature(const Polygon& part, int degree, std::vector<ParameterPoint>& points) {
    const TriangleRule& rule = triangleRule(degree);
    const std::size_t n = part.size(), first = n > 0 ? firstCorner(part) : 0;
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const Parameters& a = part[first];
        const Parameters toB = part[(first + i) % n] - a, toC = part[(first + i + 1) % n] - a;
        const double area = 0.5 * (toB[0] * toC[1] - toB[1] * toC[0]);
        if (area == 0) {
            continue;
        }
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Parameters place = a + rule.points[k][1] * toB + rule.points[k][2] * toC;
            points.push_back({place[0], place[1], area * rule.weights[k]});
        }
    }
}

} // namespace tokay::geometry
