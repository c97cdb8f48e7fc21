// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/normalSlopes.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/spline/Points.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <set>

namespace tokay::mapper {

namespace {

using geometry::CurveOnSurface;
using geometry::KnotVector;
using geometry::NurbsSurface;
using geometry::ParameterBox;

/// Knot spans that the edge runs through, and those next to its left: others than
/// the first if it runs along a knot line, to rounding.
std::set<std::array<int, 2>> cutSpans(const CurveOnSurface& edge) {
    const KnotVector &u = edge.surface().u(), &v = edge.surface().v();
    const Eigen::Vector2d size(u.last() - u.first(), v.last() - v.first());
    std::set<std::array<int, 2>> spans;
    for (std::size_t i = 0; i + 1 < edge.breakpoints().size(); ++i) {
        const double t = 0.5 * (edge.breakpoints()[i] + edge.breakpoints()[i + 1]);
        const Points c = edge.parameterCurve().derivatives(t, 1);
        const Eigen::Vector2d left =
            Eigen::Vector2d(-c(1, 1) / size[1], c(1, 0) / size[0]).normalized();
        constexpr double aside = 1e-10;
        for (const double step : {0.0, aside}) {
            spans.insert({u.findSpan(c(0, 0) + step * size[0] * left[0]),
                          v.findSpan(c(0, 1) + step * size[1] * left[1])});
        }
    }
    return spans;
}

ParameterBox boxOf(const NurbsSurface& surface, const std::array<int, 2>& span) {
    const std::vector<double>&u = surface.u().knots(), &v = surface.v().knots();
    return {{u[span[0]], v[span[1]]}, {u[span[0] + 1], v[span[1] + 1]}};
}

} // namespace

Functions directionalDerivative(const NurbsSurface& surface, double xi, double eta,
                                const Point& direction) {
    const geometry::SurfaceBasis basis = surface.basis(xi, eta, 1);
    const Points d = surface.derivatives(xi, eta, 1);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << d.row(1).transpose(), d.row(2).transpose();
    // The parameters change so along a step of length 1 in that direction.
    const Eigen::Vector2d step =
        (tangents.transpose() * tangents).inverse() * (tangents.transpose() * direction);
    return {basis.controlPoints, basis.N.bottomRows(2).transpose() * step};
}

namespace {

NormalSlope slopeAt(const CurveOnSurface& edge, double xi, double eta, double weight) {
    const Points d = edge.surface().derivatives(xi, eta, 1);
    const Point areaVector = Point(d.row(1)).cross(Point(d.row(2)));
    const geometry::CurveProjection foot = edge.closest(d.row(0));
    const Points onEdge = edge.derivatives(foot.xi, 1);
    NormalSlope slope;
    slope.foot = onEdge.row(0);
    slope.normal = areaVector.cross(Point(onEdge.row(1))).normalized();
    static_cast<Functions&>(slope) = directionalDerivative(edge.surface(), xi, eta, slope.normal);
    slope.measure = weight * areaVector.norm();
    return slope;
}

} // namespace

std::vector<ParameterBox> cutElements(const CurveOnSurface& edge) {
    std::vector<ParameterBox> boxes;
    for (const std::array<int, 2>& span : cutSpans(edge)) {
        boxes.push_back(boxOf(edge.surface(), span));
    }
    return boxes;
}

std::vector<NormalSlope> normalSlopes(const CurveOnSurface& edge) {
    const NurbsSurface& surface = edge.surface();
    const auto& alongU = geometry::gaussLegendre(surface.u().degree() + 1);
    const auto& alongV = geometry::gaussLegendre(surface.v().degree() + 1);
    std::vector<NormalSlope> slopes;
    for (const ParameterBox& box : cutElements(edge)) {
        for (std::size_t j = 0; j < alongV.points.size(); ++j) {
            for (std::size_t i = 0; i < alongU.points.size(); ++i) {
                slopes.push_back(slopeAt(edge, box.lower[0] + alongU.points[i] * box.size()[0],
                                         box.lower[1] + alongV.points[j] * box.size()[1],
                                         alongU.weights[i] * alongV.weights[j] * box.area()));
            }
        }
    }
    return slopes;
}

} // namespace tokay::mapper
