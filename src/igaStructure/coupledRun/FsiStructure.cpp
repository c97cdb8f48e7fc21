// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/FsiStructure.hpp"

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void FsiStructure::beginTimeStep(double time, double deltaT) {
    integrator_.beginTimeStep(time, deltaT);
    isLinearised_ = false;
    residualAt_.resize(0);
    nIterations_ = 0;
}

VectorXd FsiStructure::acceptedDisplacements() const {
    return boundary_.displacements(integrator_.state().displacement);
}

VectorXd FsiStructure::solve(const VectorXd& faceForces) {
    return displacements(solveUnder(map(faceForces, integrator_.displacement())));
}

VectorXd FsiStructure::solveFor(const VectorXd& loads, const VectorXd& start) {
    integrator_.singleStep().startFrom(start);
    return solveUnder(loads);
}

VectorXd FsiStructure::solveUnder(const VectorXd& loads) {
    const auto timed = timer_.enter(Phase::solving);
    integrator_.solve(loads);
    isLinearised_ = false;
    residualAt_.resize(0);                      // prescribed motions may depend on solutions
    linearisedAt_ = integrator_.displacement(); // or near it
    nIterations_ += integrator_.nIterations();
    return integrator_.displacement();
}

VectorXd FsiStructure::residual(const VectorXd& d) {
    const auto timed = timer_.enter(Phase::solving);
    if (residualAt_.size() == 0 || residualAt_ != d) {
        residual_ = integrator_.singleStep().requiredForce(d);
        residualAt_ = d;
    }
    return residual_;
}

void FsiStructure::linearise(const VectorXd& d) {
    const auto timed = timer_.enter(Phase::solving);
    if (isLinearised_ && linearisedAt_ == d) {
        return;
    }
    integrator_.singleStep().linearise(d);
    linearisedAt_ = d;
    isLinearised_ = true;
    ++nIterations_;
}

double FsiStructure::reuseContraction() const {
    return integrator_.singleStep().reuseContraction();
}

MatrixXd FsiStructure::responses(const MatrixXd& b) {
    const auto timed = timer_.enter(Phase::solving);
    return integrator_.singleStep().responses(b);
}

VectorXd FsiStructure::displacements(const VectorXd& d) {
    const auto timed = timer_.enter(Phase::mapping);
    if (displacementsAt_.size() == 0 || displacementsAt_ != d) {
        displacements_ = boundary_.displacements(d);
        displacementsAt_ = d;
    }
    return displacements_;
}

MatrixXd FsiStructure::variations(const MatrixXd& D) {
    const auto timed = timer_.enter(Phase::mapping);
    return boundary_.variations(linearisedAt_, D);
}

VectorXd FsiStructure::loads(const VectorXd& faceForces, const VectorXd& d) {
    VectorXd loads = map(faceForces, d);
    for (Eigen::Index k = 0; k < loads.size(); ++k) {
        if (model_.fixed()[static_cast<std::size_t>(k)]) {
            loads[k] = 0; // the support's
        }
    }
    return loads;
}

VectorXd FsiStructure::map(const VectorXd& faceForces, const VectorXd& d) {
    const auto timed = timer_.enter(Phase::mapping);
    mappedAt_ = d;
    return boundary_.forces(faceForces, mappedAt_);
}

} // namespace tokay::structure
