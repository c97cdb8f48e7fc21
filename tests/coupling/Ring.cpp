// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ring.hpp"

#include "common/errors.hpp"
#include "coupling/block/BlockSystem.hpp"

#include <cmath>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int nPoints = 61;
constexpr int nStepsPerPeriod = 40;
constexpr double outerRadius = 3;
constexpr double bendingStiffness = 1e-3;
constexpr double cubicStiffness = 200;
constexpr double hoopStiffness = 5;
constexpr double loadAmplitude = 0.05;

// Newmark's method, with the damping of high frequencies of α = 0.1
constexpr double alpha = 0.1;
constexpr double beta = (1 + alpha) * (1 + alpha) / 4;
constexpr double gamma = 0.5 + alpha;

/// Trigonometric functions of the points, orthonormal; columns 2n - 1 and 2n
/// have the wave number n.
MatrixXd waves(const VectorXd& angle) {
    MatrixXd result(nPoints, nPoints);
    result.col(0).setConstant(1 / std::sqrt(double(nPoints)));
    for (int n = 1; 2 * n < nPoints; ++n) {
        result.col(2 * n - 1) = std::sqrt(2.0 / nPoints) * (n * angle).array().cos();
        result.col(2 * n) = std::sqrt(2.0 / nPoints) * (n * angle).array().sin();
    }
    return result;
}

double addedMassOf(int n) {
    if (n == 0) {
        return std::log(outerRadius);
    }
    const double far = std::pow(outerRadius, -2 * n);
    return (1 - far) / (1 + far) / n;
}

double stiffnessOf(int n) {
    return 1 + bendingStiffness * std::pow(n * n - 1, 2);
}

/// The matrix that multiplies each wave by a factor of its number.
template <class Factor>
MatrixXd spectral(const MatrixXd& waves, Factor factor) {
    VectorXd factors(nPoints);
    for (int i = 0; i < nPoints; ++i) {
        factors[i] = factor((i + 1) / 2);
    }
    return waves * factors.asDiagonal() * waves.transpose();
}

MatrixXd spectralDerivative(const MatrixXd& waves) {
    MatrixXd ofWaves = MatrixXd::Zero(nPoints, nPoints);
    for (int n = 1; 2 * n < nPoints; ++n) {
        ofWaves(2 * n - 1, 2 * n) = n;
        ofWaves(2 * n, 2 * n - 1) = -n;
    }
    return waves * ofWaves * waves.transpose();
}

} // namespace

Ring::Ring(RingWall wall, double massRatio, RingFluid fluid)
    : wall_(wall), fluid_(fluid),
      angle_(VectorXd::LinSpaced(nPoints, 0, 2 * M_PI * (nPoints - 1) / nPoints)) {
    const MatrixXd w = waves(angle_);
    addedMass_ = massRatio * spectral(w, addedMassOf);
    stiffness_ = spectral(w, stiffnessOf);
    derivative_ = spectralDerivative(w);
    frequency_ = std::sqrt(stiffnessOf(2) / (1 + massRatio / 2));
    deltaT_ = 2 * M_PI / frequency_ / nStepsPerPeriod;
    olderDeltaT_ = deltaT_;
    rampTime_ = 5 * deltaT_;
    damping_ = 0.02 * frequency_ * (1 + massRatio / 2);
    x_ = velocity_ = acceleration_ = olderX_ = momentum_ = olderMomentum_ = VectorXd::Zero(nPoints);
}

void Ring::beginTimeStep() {
    time_ += deltaT_;
    load_ = drivingLoad();
}

/// A travelling bump and two standing waves, raised over five steps.
VectorXd Ring::drivingLoad() const {
    const double phase = frequency_ * time_;
    const double ramp = std::min(1.0, time_ / rampTime_);
    const auto angle = angle_.array();
    return loadAmplitude * ramp *
           (2 * (6 * ((angle - 0.7 * phase).cos() - 1)).exp() +
            (2 * angle).cos() * std::sin(phase) +
            0.5 * (5 * angle + 1).cos() * std::sin(2.3 * phase))
               .matrix();
}

VectorXd Ring::acceleration(const VectorXd& x) const {
    const VectorXd predicted =
        x_ + deltaT_ * velocity_ + deltaT_ * deltaT_ * (0.5 - beta) * acceleration_;
    return (x - predicted) / (beta * deltaT_ * deltaT_);
}

VectorXd Ring::velocity(const VectorXd& x) const {
    return velocity_ + deltaT_ * ((1 - gamma) * acceleration_ + gamma * acceleration(x));
}

VectorXd Ring::residual(const VectorXd& d) {
    VectorXd result = acceleration(d) + damping_ * velocity(d) + stiffness_ * d - load_;
    if (wall_ == RingWall::cubic) {
        result += cubicStiffness * d.array().cube().matrix();
    } else if (wall_ == RingWall::geometric) {
        const VectorXd slope = derivative_ * d;
        const VectorXd strain = d + 0.5 * slope.cwiseAbs2();
        result += hoopStiffness * (strain + derivative_.transpose() * strain.cwiseProduct(slope));
    }
    return result;
}

void Ring::linearise(const VectorXd& d) {
    MatrixXd K = stiffness_;
    K.diagonal().array() += 1 / (beta * deltaT_ * deltaT_) + damping_ * gamma / (beta * deltaT_);
    if (wall_ == RingWall::cubic) {
        K.diagonal() += 3 * cubicStiffness * d.cwiseAbs2();
    } else if (wall_ == RingWall::geometric) {
        const VectorXd slope = derivative_ * d;
        const VectorXd strain = d + 0.5 * slope.cwiseAbs2();
        const MatrixXd strainChange =
            MatrixXd::Identity(nPoints, nPoints) + slope.asDiagonal() * derivative_;
        K += hoopStiffness * (strainChange.transpose() * strainChange +
                              derivative_.transpose() * strain.asDiagonal() * derivative_);
    }
    factors_.compute(K);
}

/// Factors of the values now, before and before that in the rate of change now.
Eigen::Vector3d Ring::differences() const {
    if (fluid_.isEuler || olderDeltaT_ == 0) {
        return Eigen::Vector3d(1, -1, 0) / deltaT_;
    }
    const double q = deltaT_ / olderDeltaT_;
    return Eigen::Vector3d((1 + 2 * q) / (1 + q), -(1 + q), q * q / (1 + q)) / deltaT_;
}

VectorXd Ring::fluidVelocity(const VectorXd& x) const {
    const Eigen::Vector3d c = differences();
    return c[0] * x + c[1] * x_ + c[2] * olderX_;
}

VectorXd Ring::momentum(const VectorXd& x) const {
    return addedMass_ * fluidVelocity(x);
}

VectorXd Ring::fluid(const VectorXd& x) {
    if (!(x.cwiseAbs().maxCoeff() < 50)) {
        throw SolverError("the ring has left its fluid");
    }
    const Eigen::Vector3d c = differences();
    return -(c[0] * momentum(x) + c[1] * momentum_ + c[2] * olderMomentum_) -
           fluid_.damping * damping_ * fluidVelocity(x) - fluid_.stiffness * (stiffness_ * x);
}

/// The fluid responds linearly, by the full matrix J: Newton's method on the
/// joint equations, whose balance is verified.
VectorXd Ring::monolithic(const VectorXd& start) {
    const MatrixXd identity = MatrixXd::Identity(nPoints, nPoints);
    const double rate = differences()[0];
    LowRankMatrix J;
    J.append(-rate * rate * addedMass_ - fluid_.damping * damping_ * rate * identity -
                 fluid_.stiffness * stiffness_,
             identity);
    const VectorXd forces = fluid(start);
    WoodburySolver steps(*this);
    const VectorXd x = BlockSystem(*this, steps, forces, start, J).solve(start, 1e-12);
    const double imbalance = (residual(x) - fluid(x)).norm();
    if (!(imbalance < 1e-9 * (load_.norm() + fluid(x).norm()))) {
        throw SolverError("the reference solution of the ring is wrong");
    }
    return x;
}

void Ring::acceptTimeStep(const VectorXd& x) {
    const VectorXd newMomentum = momentum(x);
    const VectorXd newAcceleration = acceleration(x);
    velocity_ = velocity(x);
    acceleration_ = newAcceleration;
    olderMomentum_ = momentum_;
    momentum_ = newMomentum;
    olderX_ = x_;
    x_ = x;
    olderDeltaT_ = deltaT_;
}

} // namespace tokay::coupling
