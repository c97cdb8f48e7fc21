// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/BeamPoints.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/assembly/GeometryError.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

namespace {

std::string describe(const geometry::Point& x) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

void requireTangent(const geometry::Point& at, double length) {
    if (!(length > 0)) {
        throw GeometryError(fmt::format("the line has no tangent at {}: its line element is {:g} "
                                        "m; control points must not coincide there",
                                        describe(at), length));
    }
}

// Whether the tangent is continuous where a knot span begins.
bool isSmooth(const geometry::KnotVector& knots, std::size_t span) {
    return knots.multiplicity(knots.breakpoints()[span]) < knots.degree();
}

// A line that turns back has a cusp between neighbouring points.
void requireOnward(const BeamPoint& before, const geometry::Points& derivatives) {
    constexpr double turnedBack = -0.9;
    const Eigen::Vector3d tangent = derivatives.row(1).normalized();
    const double cosine = before.position.first.normalized().dot(tangent);
    if (cosine < turnedBack) {
        throw GeometryError(fmt::format(
            "the line turns back on itself between {} and {}: its tangent turns by {:.3g} degrees "
            "from one quadrature point to the next; its control points must run onwards",
            describe(before.at), describe(derivatives.row(0)),
            180 / M_PI * std::acos(std::max(-1.0, cosine))));
    }
}

} // namespace

BeamDerivatives BeamPoint::derivatives(const Eigen::VectorXd& field) const {
    BeamDerivatives sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (int a = 0; a < N.cols(); ++a) {
        for (int c = 0; c < dimension; ++c) {
            const double value = field[dimension * (first + a) + c];
            sum.first[c] += N(1, a) * value;
            sum.second[c] += N(2, a) * value;
        }
    }
    return sum;
}

std::vector<BeamPoint> beamPoints(const geometry::NurbsCurve& curve, int nPointsPerElement,
                                  int dimension) {
    const std::vector<double>& breakpoints = curve.knotVector().breakpoints();
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(nPointsPerElement);
    std::vector<BeamPoint> points;
    for (std::size_t element = 0; element + 1 < breakpoints.size(); ++element) {
        const double span = breakpoints[element + 1] - breakpoints[element];
        for (int g = 0; g < nPointsPerElement; ++g) {
            const double xi = breakpoints[element] + rule.points[g] * span;
            const geometry::Points derivatives = curve.derivatives(xi, 2);
            geometry::CurveBasis basis = curve.basis(xi, 2);
            const double length = derivatives.row(1).norm() * rule.weights[g] * span;
            requireTangent(derivatives.row(0), length);
            if (!points.empty() && (g > 0 || isSmooth(curve.knotVector(), element))) {
                requireOnward(points.back(), derivatives);
            }
            points.push_back({dimension,
                              static_cast<int>(element),
                              basis.first,
                              std::move(basis.N),
                              {derivatives.row(1), derivatives.row(2)},
                              derivatives.row(0),
                              length});
        }
    }
    return points;
}

} // namespace tokay::structure
