// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "coupling/step/StepHistory.hpp"

#include <Eigen/Core>

namespace tokay::coupling {

/// A fluid that makes one corrector per coupling iteration lags behind the last
/// displacement: L_k = L(x_k) + q (L_{k-1} - L(x_k)), L being what its forces do to
/// the structure. This corrects the loads for a part of the lag and tells which
/// differences are worth learning.
class FluidLag : public StepHistory {
  public:
    struct Options {
        double fluidMemory = 0; ///< q; 0: the fluid converges
        double memoryContrast = 5;

        static const SchemaOf<Options>& schema() {
            static const SchemaOf<Options> schema = {
                {"fluidMemory", &Options::fluidMemory, "[0, 1)", "",
                 "Fraction of its last response that the fluid keeps from one coupling iteration "
                 "to the next, for which the forces are corrected."},
                {"memoryContrast", &Options::memoryContrast, "[0, inf)", "",
                 "A difference is used if it exceeds this multiple of what the last one has left "
                 "behind by the fluid's memory."}};
            return schema;
        }
    };

    explicit FluidLag(const Options& options) : options_(options) {}

    void beginTimeStep() override;

    /// Estimate of the converged fluid's L; the first loads of a step are taken as
    /// they are.
    Eigen::VectorXd corrected(const Eigen::VectorXd& loads);

    /// Whether the last two loads differ by more than memory alone explains.
    bool isInformative() const;

    void rejectTimeStep() override { last_ = atBegin_; }
    void save(StateWriter& state) const override;
    void restore(StateReader& state) override;

  private:
    /// Loads as they came, and what they differed from the ones before.
    struct Last {
        Eigen::VectorXd loads; ///< empty: none yet, or share 0
        double change = 0;     ///< |L_k - L_{k-1}|
    };

    Options options_;
    bool isFirst_ = true;
    Last last_;
    Last atBegin_;
    double changeBefore_ = 0;
};

} // namespace tokay::coupling
