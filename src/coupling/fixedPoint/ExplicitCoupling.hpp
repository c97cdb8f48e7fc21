// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "coupling/fixedPoint/Accelerator.hpp"

namespace tokay::coupling {

/// x stays as predicted: for a structure so heavy that one coupling iteration per
/// time step is enough.
class ExplicitCoupling : public Accelerator {
  public:
    struct Options {
        static const SchemaOf<Options>& schema() {
            static const SchemaOf<Options> none;
            return none;
        }
    };

    explicit ExplicitCoupling(const Options&) {}

    bool iterates() const override { return false; }
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& /*xTilde*/,
                         double /*fluidResidual*/) override {
        return x;
    }
};

} // namespace tokay::coupling
