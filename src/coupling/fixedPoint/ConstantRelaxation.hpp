// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "coupling/fixedPoint/Accelerator.hpp"

namespace tokay::coupling {

/// x + relaxation (xTilde - x)
class ConstantRelaxation : public Accelerator {
  public:
    struct Options {
        double relaxation = 0.5;

        static const SchemaOf<Options>& schema() {
            static const SchemaOf<Options> schema = {
                {"relaxation", &Options::relaxation, "(0, 2]", "",
                 "Relaxation factor: fraction of the residual that is added."}};
            return schema;
        }
    };

    explicit ConstantRelaxation(const Options& options) : relaxation_(options.relaxation) {}

    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                         double /*fluidResidual*/) override {
        return x + relaxation_ * (xTilde - x);
    }

  private:
    double relaxation_;
};

} // namespace tokay::coupling
