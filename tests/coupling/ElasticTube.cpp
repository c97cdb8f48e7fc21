// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElasticTube.hpp"

#include "common/errors.hpp"

#include <Eigen/LU>

#include <cmath>
#include <complex>

namespace tokay::coupling {
namespace {

/// Puts one value before and one behind.
template <class Scalar, class Values>
Eigen::Array<Scalar, Eigen::Dynamic, 1> extended(const Scalar& first, const Values& values,
                                                 const Scalar& last) {
    Eigen::Array<Scalar, Eigen::Dynamic, 1> result(values.size() + 2);
    result << first, values, last;
    return result;
}

/// Sum of, or difference between, what both faces of each cell carry.
template <class Values>
auto upper(const Values& v) {
    return v.tail(v.size() - 1);
}
template <class Values>
auto lower(const Values& v) {
    return v.head(v.size() - 1);
}

} // namespace

ElasticTube::ElasticTube(int nCells, double stiffness, double deltaT)
    : nCells_(nCells), squaredWaveSpeed_(stiffness * stiffness), deltaT_(deltaT),
      cellLength_(1.0 / nCells), stabilisation_(1 / (1 + cellLength_ / deltaT)),
      oldFlow_(2 * nCells), oldArea_(Vector<double>::Ones(nCells)) {
    oldFlow_ << Vector<double>::Ones(nCells), Vector<double>::Zero(nCells);
    flow_ = oldFlow_;
}

void ElasticTube::beginTimeStep() {
    ++step_;
    inletVelocity_ = 1 + 0.1 * std::pow(std::sin(M_PI * step_ * deltaT_), 2);
    flow_ = oldFlow_;
}

template <class Scalar>
ElasticTube::Vector<Scalar> ElasticTube::areaOf(const Vector<Scalar>& pressure) const {
    const double c2 = 2 * squaredWaveSpeed_;
    return (c2 / (c2 - pressure)).square();
}

template <class Scalar>
ElasticTube::Vector<Scalar> ElasticTube::imbalance(const Vector<Scalar>& flow,
                                                   const Vector<Scalar>& area) const {
    const int n = nCells_;
    const Vector<Scalar> u = flow.head(n);
    const Vector<Scalar> p = flow.tail(n);

    const Scalar uOut = 2.0 * u[n - 1] - u[n - 2];
    const Scalar root =
        std::sqrt(squaredWaveSpeed_ - outletPressure_ / 2) - (uOut - outletVelocity_) / 4.0;
    const Scalar pOut = 2.0 * (squaredWaveSpeed_ - root * root);
    const Vector<Scalar> allU = extended<Scalar>(inletVelocity_, u, uOut);
    const Vector<Scalar> allP = extended<Scalar>(2.0 * p[0] - p[1], p, pOut);
    const Vector<Scalar> allA = extended<Scalar>(area[0], area, area[n - 1]);

    const Vector<Scalar> faceArea = 0.5 * (upper(allA) + lower(allA));
    const Vector<Scalar> volumeFlux = 0.5 * (upper(allU) + lower(allU)) * faceArea;
    const Vector<Scalar> pressureDrop = upper(allP) - lower(allP);
    const Vector<Scalar> massFlux = volumeFlux - stabilisation_ * pressureDrop;
    const Vector<Scalar> momentumFlux = lower(allU) * volumeFlux; // upwind
    const Vector<Scalar> thrust = 0.5 * faceArea * pressureDrop;

    Vector<Scalar> result(2 * n);
    result.head(n) =
        (area - oldArea_) * cellLength_ + deltaT_ * (upper(massFlux) - lower(massFlux));
    result.tail(n) =
        (u * area - oldFlow_.head(n) * oldArea_) * cellLength_ +
        deltaT_ * (upper(momentumFlux) - lower(momentumFlux) + upper(thrust) + lower(thrust));
    return result;
}

/// Newton's method, the Jacobian by complex steps (exact to rounding errors).
template <class AreaOfFlow>
void ElasticTube::solveFlow(const AreaOfFlow& areaOfFlow) {
    using Complex = std::complex<double>;
    constexpr double step = 1e-30;
    for (int i = 0; i < 30; ++i) {
        Eigen::MatrixXd jacobian(2 * nCells_, 2 * nCells_);
        for (int j = 0; j < 2 * nCells_; ++j) {
            Vector<Complex> flow = flow_.cast<Complex>();
            flow[j] += Complex(0, step);
            jacobian.col(j) = imbalance<Complex>(flow, areaOfFlow(flow)).imag() / step;
        }
        const Vector<double> change =
            jacobian.partialPivLu()
                .solve(imbalance<double>(flow_, areaOfFlow(flow_)).matrix())
                .array();
        flow_ -= change;
        if (!flow_.allFinite()) {
            break;
        }
        if (change.matrix().norm() < 1e-12 * flow_.matrix().norm()) {
            return;
        }
    }
    throw SolverError("the flow through the tube was not found");
}

Eigen::VectorXd ElasticTube::fluid(const Eigen::VectorXd& x) {
    const Vector<double> area = 1 + x.array();
    if (!(area.minCoeff() > 1e-2 && area.maxCoeff() < 100)) {
        throw SolverError("the tube is closed or has burst");
    }
    flow_ = oldFlow_; // whatever an earlier call may have ended in
    solveFlow([&area](const auto& flow) {
        return area.cast<typename std::decay_t<decltype(flow)>::Scalar>().eval();
    });
    return flow_.tail(nCells_).matrix();
}

Eigen::VectorXd ElasticTube::residual(const Eigen::VectorXd& x) {
    return (2 * squaredWaveSpeed_ * (1 - (1 + x.array()).rsqrt())).matrix();
}

void ElasticTube::linearise(const Eigen::VectorXd& x) {
    tangent_ = squaredWaveSpeed_ * (1 + x.array()).pow(-1.5);
}

Eigen::MatrixXd ElasticTube::responses(const Eigen::MatrixXd& b) {
    return tangent_.inverse().matrix().asDiagonal() * b;
}

Eigen::VectorXd ElasticTube::structure(const Eigen::VectorXd& pressure,
                                       const Eigen::VectorXd& /*start*/) {
    return (areaOf<double>(pressure.array()) - 1).matrix();
}

Eigen::VectorXd ElasticTube::monolithic(const Eigen::VectorXd& start) {
    flow_ = oldFlow_;
    solveFlow([this](const auto& flow) {
        using Scalar = typename std::decay_t<decltype(flow)>::Scalar;
        return areaOf<Scalar>(flow.tail(nCells_));
    });
    return structure(flow_.tail(nCells_).matrix(), start);
}

void ElasticTube::acceptTimeStep(const Eigen::VectorXd& x) {
    const double uOut = 2 * flow_[nCells_ - 1] - flow_[nCells_ - 2];
    const double root =
        std::sqrt(squaredWaveSpeed_ - outletPressure_ / 2) - (uOut - outletVelocity_) / 4;
    outletPressure_ = 2 * (squaredWaveSpeed_ - root * root);
    outletVelocity_ = uOut;
    oldFlow_ = flow_;
    oldArea_ = 1 + x.array();
}

} // namespace tokay::coupling
