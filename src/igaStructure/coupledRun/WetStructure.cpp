// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/WetStructure.hpp"

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void WetStructure::beginTimeStep(double time, double deltaT) {
    integrator_.beginTimeStep(time, deltaT);
    factoredAt_.resize(0);
    nIterations_ = 0;
}

VectorXd WetStructure::answer(const std::vector<double>& forces) {
    mappedAt_ = integrator_.displacement();
    return answerTo(
        timer_.time(Phase::mapping, [&] { return boundary_.forces(forces, mappedAt_); }));
}

VectorXd WetStructure::answerTo(const VectorXd& loads) {
    timer_.time(Phase::solving, [&] { integrator_.solve(loads); });
    factoredAt_.resize(0);
    nIterations_ += integrator_.nIterations();
    return timer_.time(Phase::mapping,
                       [&] { return boundary_.displacements(integrator_.displacement()); });
}

VectorXd WetStructure::residual(const VectorXd& d) {
    return integrator_.singleStep().requiredForce(d);
}

void WetStructure::factor(const VectorXd& d) {
    if (factoredAt_.size() == d.size() && factoredAt_ == d) {
        return;
    }
    integrator_.singleStep().linearise(d);
    factoredAt_ = d;
    ++nIterations_;
}

VectorXd WetStructure::displacements(const VectorXd& d) {
    return boundary_.displacements(d);
}

MatrixXd WetStructure::variations(const MatrixXd& D) {
    return boundary_.variations(factoredAt_, D);
}

VectorXd WetStructure::loads(const VectorXd& forces, const VectorXd& d) {
    mappedAt_ = d;
    VectorXd loads = boundary_.forces({forces.data(), forces.data() + forces.size()}, d);
    for (Eigen::Index k = 0; k < loads.size(); ++k) {
        if (model_.fixed()[static_cast<std::size_t>(k)]) {
            loads[k] = 0; // the support's
        }
    }
    return loads;
}

} // namespace tokay::structure
