// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/StepHistory.hpp"

#include <Eigen/Core>

namespace tokay::coupling {

/// A fluid that makes one corrector per coupling iteration lags behind the last
/// displacement: L_k = L(x_k) + q (L_{k-1} - L(x_k)), L being what its forces do to
/// the structure. This corrects the loads for a part of the lag and tells which
/// differences are worth learning.
class FluidLag : public StepHistory {
  public:
    /// @param share     q, at least 0 and below 1; 0: the fluid converges
    /// @param contrast  how many times a difference must exceed what the last
    ///                  one can have left behind
    FluidLag(double share, double contrast) : share_(share), contrast_(contrast) {}

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

    double share_;
    double contrast_;
    bool isFirst_ = true;
    Last last_;
    Last atBegin_;
    double changeBefore_ = 0;
};

} // namespace tokay::coupling
