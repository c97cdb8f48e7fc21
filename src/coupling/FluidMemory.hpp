// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// A fluid that makes one corrector an exchange falls short of its answer to
/// the last displacement: L_k = L(x_k) + q (L_{k-1} - L(x_k)), L being what its
/// forces do to the structure. This corrects the loads for a part of it and tells
/// which differences are worth learning.
class FluidMemory {
  public:
    /// @param share     q, at least 0 and below 1; 0: the fluid converges
    /// @param contrast  how many times a difference must exceed what the last
    ///                  one can have left behind
    FluidMemory(double share, double contrast) : share_(share), contrast_(contrast) {}

    void beginTimeStep();

    /// L of the fluid that had converged, as far as it can be told; the first
    /// loads of a step are taken as they are.
    Eigen::VectorXd corrected(const Eigen::VectorXd& loads);

    /// Whether the last two loads differ by more than memory alone explains.
    bool teaches() const;

    /// Forgets the loads of this step.
    void rejectTimeStep() { last_ = atBegin_; }

    /// Of the last loads, between two time steps.
    void save(StateWriter& state) const;
    void restore(StateReader& state);

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
