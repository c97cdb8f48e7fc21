// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/Accelerator.hpp"

namespace tokay::coupling {

/// x + relaxation (xTilde - x)
class ConstantRelaxation : public Accelerator {
  public:
    explicit ConstantRelaxation(const CouplingOptions& options) : relaxation_(options.relaxation) {}

    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                         double /*fluidResidual*/) override {
        return x + relaxation_ * (xTilde - x);
    }

  private:
    double relaxation_;
};

} // namespace tokay::coupling
