// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/BeamForce.hpp"

#include "igaStructure/kinematics/beam/planeVectors.hpp"

#include <algorithm>
#include <cassert>

namespace tokay::structure {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Formulas need not be polynomials: two points more than the basis needs.
constexpr int additionalAxisPoints = 2;

Vector3d evaluate(const std::vector<Formula>& formulas, const geometry::Point& at, double time) {
    Vector3d vector = Vector3d::Zero();
    for (std::size_t c = 0; c < formulas.size(); ++c) {
        vector[c] = formulas[c](at, time);
    }
    return vector;
}

void spread(const BeamPoint& point, const Eigen::Ref<const VectorXd>& force, VectorXd& sum) {
    for (int a = 0; a < point.N.cols(); ++a) {
        sum.segment(point.dimension * (point.first + a), point.dimension) += point.N(0, a) * force;
    }
}

} // namespace

BeamForce::BeamForce(const geometry::NurbsCurve& curve, const BeamSection& section, BeamLoads loads,
                     int dimension)
    : section_(section), loads_(std::move(loads)), dimension_(dimension),
      points_(beamPoints(curve, curve.degree() + additionalAxisPoints, dimension)),
      nUnknowns_(dimension * curve.nControlPoints()),
      hasFollowers_(!loads_.pressures.empty() ||
                    std::any_of(loads_.ends.begin(), loads_.ends.end(),
                                [](const EndLoad& load) { return load.moment.has_value(); })) {
    assert(dimension == 2 || !hasFollowers_);
    for (int k = 0; k < 2; ++k) {
        const double xi = k == 0 ? curve.knotVector().first() : curve.knotVector().last();
        geometry::CurveBasis basis = curve.basis(xi, 1);
        const geometry::Points derivatives = curve.derivatives(xi, 1);
        ends_[k] = {derivatives.row(0), basis.first, std::move(basis.N),
                    derivatives.row(1).head<2>()};
    }
}

VectorXd BeamForce::dead(double time) const {
    VectorXd force = VectorXd::Zero(nUnknowns_);
    for (const BeamPoint& point : points_) {
        Vector3d density = Vector3d::Zero(); // per length
        for (const auto& traction : loads_.tractions) {
            density += section_.width * evaluate(traction, point.at, time);
        }
        for (const auto& gravity : loads_.gravities) {
            density += section_.mass * evaluate(gravity, point.at, time);
        }
        spread(point, point.length * density.head(dimension_), force);
    }
    for (const EndLoad& load : loads_.ends) {
        if (load.force) {
            const int first = load.end == BeamEnd::start ? 0 : nUnknowns_ - dimension_;
            force.segment(first, dimension_) +=
                evaluate(*load.force, end(load.end).at, time).head(dimension_);
        }
    }
    return force;
}

Vector2d BeamForce::currentTangent(const End& end, const VectorXd& displacement) const {
    Vector2d tangent = end.tangent;
    for (int a = 0; a < end.N.cols(); ++a) {
        tangent += end.N(1, a) * displacement.segment<2>(2 * (end.first + a));
    }
    return tangent;
}

double BeamForce::pressureAt(const BeamPoint& point, double time) const {
    double sum = 0;
    for (const Formula& pressure : loads_.pressures) {
        sum += pressure(point.at, time);
    }
    return sum;
}

bool BeamForce::hasUniformPressure() const {
    return std::none_of(loads_.pressures.begin(), loads_.pressures.end(),
                        [](const Formula& pressure) { return pressure.dependsOnPlace(); });
}

VectorXd BeamForce::followers(double time, const VectorXd& displacement) const {
    VectorXd force = VectorXd::Zero(nUnknowns_);
    for (const EndLoad& load : loads_.ends) {
        if (!load.moment) {
            continue;
        }
        const End& end = this->end(load.end);
        const Vector2d tangent = currentTangent(end, displacement);
        const Vector2d lever = turned(tangent) / tangent.squaredNorm(); // angle by the tangent
        const double moment = (*load.moment)(end.at, time);
        for (int a = 0; a < end.N.cols(); ++a) {
            force.segment<2>(2 * (end.first + a)) += moment * end.N(1, a) * lever;
        }
    }
    if (loads_.pressures.empty()) {
        return force;
    }
    for (const BeamPoint& point : points_) {
        const double parameters = point.length / point.position.first.norm();
        const Vector2d tangent =
            (point.position.first + point.derivatives(displacement).first).head<2>();
        spread(point, -section_.width * pressureAt(point, time) * parameters * turned(tangent),
               force);
    }
    return force;
}

Eigen::MatrixXd BeamForce::momentTangent(const EndLoad& load, double time,
                                         const VectorXd& displacement) const {
    const End& end = this->end(load.end);
    const Vector2d a = currentTangent(end, displacement);
    const double square = a.squaredNorm();
    Eigen::Matrix2d turn;
    turn << 0, -1, 1, 0;
    const Eigen::Matrix2d hessian = (*load.moment)(end.at, time) / (square * square) *
                                    (square * turn - 2 * turned(a) * a.transpose());
    const int n = static_cast<int>(end.N.cols());
    Eigen::MatrixXd tangent(2 * n, 2 * n);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            tangent.block<2, 2>(2 * i, 2 * j) = end.N(1, i) * end.N(1, j) * hessian;
        }
    }
    return tangent;
}

Eigen::MatrixXd BeamForce::pressureTangent(const BeamPoint& point, double pressure) const {
    const double factor = -section_.width * pressure * point.length / point.position.first.norm();
    const int n = static_cast<int>(point.N.cols());
    Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double part = factor * point.N(0, i) * point.N(1, j);
            tangent(2 * i, 2 * j + 1) = -part;
            tangent(2 * i + 1, 2 * j) = part;
        }
    }
    return tangent;
}

} // namespace tokay::structure
