#pragma once

#include <Eigen/Core>

namespace tokay::coupling {

/// A fluid that makes one corrector an exchange falls short of its answer to
/// the last displacement: F_k = F(x_k) + q (F_{k-1} - F(x_k)). This corrects
/// the forces for a part of it and tells which differences are worth learning.
class FluidMemory {
  public:
    /// @param share     q, at least 0 and below 1; 0: the fluid converges
    /// @param contrast  how many times a difference must exceed what the last
    ///                  one can have left behind
    FluidMemory(double share, double contrast) : share_(share), contrast_(contrast) {}

    void beginTimeStep() { isFirst_ = true; }

    /// F of the fluid that had converged, as far as it can be told; the first
    /// forces of a step are taken as they are.
    Eigen::VectorXd corrected(const Eigen::VectorXd& forces);

    /// Whether the last two forces differ by more than memory alone explains.
    bool teaches() const;

  private:
    double share_;
    double contrast_;
    bool isFirst_ = true;
    Eigen::VectorXd previous_; ///< forces as they came; empty: none yet
    double lastChange_ = 0;    ///< |F_k - F_{k-1}|
    double changeBefore_ = 0;
};

} // namespace tokay::coupling
