// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/Accelerator.hpp"

namespace tokay::coupling {

/// x stays as predicted: for a structure so heavy that one coupling iteration per
/// time step is enough.
class ExplicitCoupling : public Accelerator {
  public:
    explicit ExplicitCoupling(const CouplingOptions&) {}

    bool iterates() const override { return false; }
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& /*xTilde*/,
                         double /*fluidResidual*/) override {
        return x;
    }
};

} // namespace tokay::coupling
