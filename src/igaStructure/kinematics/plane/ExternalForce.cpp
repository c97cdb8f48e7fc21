// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/ExternalForce.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/kinematics/plane/PlaneElement.hpp"

namespace tokay::structure {

namespace {

// Formulas need not be polynomials: two points more than the basis needs.
constexpr int additionalLoadPoints = 2;

bool dependsOnTime(const std::array<Formula, 2>& formulas) {
    return formulas[0].dependsOnTime() || formulas[1].dependsOnTime();
}

Eigen::Vector2d evaluate(const std::array<Formula, 2>& formulas, double x, double y, double time) {
    return {formulas[0]({x, y, 0}, time), formulas[1]({x, y, 0}, time)};
}

} // namespace

ExternalForce::ExternalForce(geometry::NurbsSurface surface, const PlaneMaterial& material,
                             Loads loads)
    : surface_(std::move(surface)), material_(material),
      constant_(Eigen::VectorXd::Zero(2 * surface_.nControlPoints())) {
    for (SideTraction& load : loads.tractions) {
        if (dependsOnTime(load.traction)) {
            varying_.tractions.push_back(std::move(load));
        } else {
            add(load, 0, constant_);
        }
    }
    for (Gravity& load : loads.gravities) {
        if (dependsOnTime(load.acceleration)) {
            varying_.gravities.push_back(std::move(load));
        } else {
            add(load, 0, constant_);
        }
    }
}

const Eigen::VectorXd& ExternalForce::at(double time) {
    force_ = constant_;
    for (const SideTraction& load : varying_.tractions) {
        add(load, time, force_);
    }
    for (const Gravity& load : varying_.gravities) {
        add(load, time, force_);
    }
    return force_;
}

void ExternalForce::add(const SideTraction& load, double time, Eigen::VectorXd& force) const {
    const geometry::BoundaryCurve boundary = surface_.boundaryCurve(load.edge);
    const std::vector<double>& breakpoints = boundary.curve.knotVector().breakpoints();
    const geometry::QuadratureRule& rule =
        geometry::gaussLegendre(boundary.curve.degree() + additionalLoadPoints);
    for (std::size_t span = 0; span + 1 < breakpoints.size(); ++span) {
        const double length = breakpoints[span + 1] - breakpoints[span];
        for (std::size_t g = 0; g < rule.points.size(); ++g) {
            const double xi = breakpoints[span] + rule.points[g] * length;
            const geometry::Points derivatives = boundary.curve.derivatives(xi, 1);
            const geometry::CurveBasis basis = boundary.curve.basis(xi, 0);
            const double area =
                derivatives.row(1).norm() * rule.weights[g] * length * material_.thickness;
            const Eigen::Vector2d traction =
                evaluate(load.traction, derivatives(0, 0), derivatives(0, 1), time);
            for (int a = 0; a < basis.N.cols(); ++a) {
                force.segment<2>(2 * boundary.controlPoints[basis.first + a]) +=
                    basis.N(0, a) * area * traction;
            }
        }
    }
}

void ExternalForce::add(const Gravity& load, double time, Eigen::VectorXd& force) const {
    const TabulatedBasis u(surface_.u(), surface_.u().degree() + additionalLoadPoints);
    const TabulatedBasis v(surface_.v(), surface_.v().degree() + additionalLoadPoints);
    const PatchNodes controlPoints({surface_.u(), surface_.v()}, surface_.controlPoints(),
                                   surface_.weights(), true);
    PlaneElement element(surface_, controlPoints, u, v);
    for (int spanV = 0; spanV < v.nSpans(); ++spanV) {
        for (int spanU = 0; spanU < u.nSpans(); ++spanU) {
            element.moveToElement(spanU, spanV);
            for (int point = 0; point < element.nPoints(); ++point) {
                element.moveToPoint(point);
                const Eigen::Vector2d x = element.position();
                const Eigen::Vector2d pull = material_.density * material_.thickness *
                                             element.area() *
                                             evaluate(load.acceleration, x[0], x[1], time);
                for (int a = 0; a < element.nFunctions(); ++a) {
                    force.segment<2>(2 * element.nodes()[a]) += element.values()[a] * pull;
                }
            }
        }
    }
}

} // namespace tokay::structure
