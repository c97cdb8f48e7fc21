// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/couplingMethods.hpp"

namespace tokay::coupling {

/// A coupling method whose structure takes the forces for its solution x̃, so that a
/// test can give that directly.
class GivenSolution : private CoupledStructure {
  public:
    GivenSolution(const CouplingOptions& options, double tolerance, const Eigen::VectorXd& initial)
        : initial_(initial), method_(makeCouplingMethod(options, tolerance, *this)) {}

    CouplingMethod& operator*() { return *method_; }
    CouplingMethod* operator->() { return method_.get(); }

  private:
    Eigen::VectorXd acceptedDisplacements() const override { return initial_; }
    Eigen::VectorXd solve(const Eigen::VectorXd& faceForces) override { return faceForces; }

    Eigen::VectorXd initial_;
    std::unique_ptr<CouplingMethod> method_;
};

} // namespace tokay::coupling
