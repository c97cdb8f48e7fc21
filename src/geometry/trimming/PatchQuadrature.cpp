// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/PatchQuadrature.hpp"

#include "common/errors.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/quadrature/polygonRegion.hpp"
#include "geometry/quadrature/triangleRule.hpp"
#include "geometry/trimming/tileRule.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

void checkOptions(const QuadratureOptions& options) {
    constexpr int most = 100;
    if (options.degree < 0 || options.degree > most) {
        throw InputError(fmt::format("the degree of quadrature is {}: choose 0 (by the basis) to "
                                     "{}",
                                     options.degree, most));
    }
    if (options.nAlong < 0 || options.nAlong > most) {
        throw InputError(fmt::format("the number of points along a curved side is {}: choose 0 "
                                     "(by the degrees) to {}",
                                     options.nAlong, most));
    }
    if (!(options.chordTolerance > 0 && options.chordTolerance <= 1)) {
        throw InputError(fmt::format("the chord tolerance is {}: it must be positive, in element "
                                     "sizes, and at most 1",
                                     options.chordTolerance));
    }
}

std::vector<ParameterPoint> fullRule(const ParameterBox& box, int degree) {
    const QuadratureRule& rule = gaussLegendre(degree / 2 + 1);
    std::vector<ParameterPoint> points;
    for (std::size_t l = 0; l < rule.points.size(); ++l) {
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            points.push_back({box.lower[0] + box.size()[0] * rule.points[k],
                              box.lower[1] + box.size()[1] * rule.points[l],
                              rule.weights[k] * rule.weights[l] * box.area()});
        }
    }
    return points;
}

std::vector<ParameterPoint> tileRules(const std::vector<Tile>& tiles,
                                      const QuadratureOptions& options) {
    std::vector<ParameterPoint> points;
    for (const Tile& tile : tiles) {
        appendTileRule(tile, options.degree, options.nAlong, points);
    }
    return points;
}

std::vector<ParameterPoint> triangleRules(const Region& region, int degree) {
    const TriangleRule& rule = triangleRule(2 * degree);
    std::vector<ParameterPoint> points;
    for (const auto& [a, b, c] : triangulated(region)) {
        const double area = signedArea(Polygon{a, b, c});
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Barycentric& at = rule.points[k];
            const Parameters place = at[0] * a + at[1] * b + at[2] * c;
            points.push_back({place[0], place[1], rule.weights[k] * area});
        }
    }
    return points;
}

} // namespace

CutRule cutRuleFromName(const std::string& name) {
    if (name == "boundaryExact") {
        return CutRule::boundaryExact;
    }
    if (name == "triangulated") {
        return CutRule::triangulated;
    }
    throw InputError(fmt::format("there is no rule \"{}\" for cut elements: choose "
                                 "boundaryExact or triangulated",
                                 name));
}

PatchQuadrature::PatchQuadrature(const TrimmedPatch& patch, const QuadratureOptions& options)
    : patch_(patch), options_(options) {
    checkOptions(options_);
    if (options_.degree == 0) {
        options_.degree = 2 * std::max(patch.basis().u().degree(), patch.basis().v().degree());
    }
    if (options_.rule != CutRule::triangulated || !patch.isTrimmed()) {
        return;
    }
    Parameters smallest = patch.box().size();
    for (int element = 0; element < patch.nElements(); ++element) {
        smallest = smallest.cwiseMin(patch.elementBox(element).size());
    }
    const Region loops = patch.tessellatedLoops(options_.chordTolerance * smallest);
    for (int j = 0; j < patch.nElementsV(); ++j) {
        ParameterBox row = patch.elementBox(j * patch.nElementsU());
        row.upper[0] = patch.box().upper[0];
        rows_.push_back(intersection(loops, row));
    }
}

std::vector<Polygon> PatchQuadrature::region(int element) const {
    return intersection(rows_[element / patch_.nElementsU()], patch_.elementBox(element));
}

std::vector<ParameterPoint> PatchQuadrature::points(int element) const {
    if (patch_.state(element) == ElementState::empty) {
        return {};
    }
    if (patch_.state(element) == ElementState::full) {
        return fullRule(patch_.elementBox(element), options_.degree);
    }
    if (options_.rule == CutRule::triangulated) {
        return triangleRules(region(element), options_.degree);
    }
    return tileRules(patch_.tiles(element), options_);
}

double area(const PatchQuadrature& quadrature, int element) {
    double area = 0;
    for (const ParameterPoint& point : quadrature.points(element)) {
        const Points d = quadrature.patch().basis().derivatives(point.xi, point.eta, 1);
        const Point alongXi = d.row(1), alongEta = d.row(2);
        area += point.weight * alongXi.cross(alongEta).norm();
    }
    return area;
}

double area(const PatchQuadrature& quadrature) {
    double sum = 0;
    for (int element = 0; element < quadrature.patch().nElements(); ++element) {
        sum += area(quadrature, element);
    }
    return sum;
}

} // namespace tokay::geometry
