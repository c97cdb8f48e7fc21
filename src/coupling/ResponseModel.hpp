// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/CouplingOptions.hpp"
#include "coupling/LowRankMatrix.hpp"

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// A Jacobian J learned from noisy differences v -> w and carried from step to
/// step. P, the identity at the start of a step, says in which directions of v
/// the step has taught nothing yet; a difference whose noise is λ, in units of
/// v, enters as
///   J += (w - J v) gᵀ,  P -= P v gᵀ,  g = P v / (vᵀ P v + λ²).
/// Without noise that is the multi-vector method: of all matrices that satisfy
/// the differences of the step the nearest to the last step's. J is compressed
/// whenever its rank exceeds largestRank, so that time and memory stay bounded.
/// Source: Ljung 1999, System Identification, 2nd edition, section 11.2
/// (recursive least squares as a Kalman filter).
class ResponseModel {
  public:
    /// Uses filterLimit, the least noise of a difference over the part of it of
    /// which the step has taught already, and largestRank, rankLimit.
    explicit ResponseModel(const CouplingOptions& options) : options_(options) {}

    void beginTimeStep();

    void learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w, double noise);

    /// Nothing has been learned yet: J is zero.
    bool isIgnorant() const { return J_.rank() == 0; }

    const LowRankMatrix& matrix() const { return J_; }

    /// Learns anew: J is zero.
    void forget() {
        J_ = {};
        taught_ = {};
    }

    void acceptTimeStep();

    /// Forgets the differences of this step.
    void rejectTimeStep() { J_ = atBegin_; }

    /// Of J, between two time steps.
    void save(StateWriter& state) const;
    /// The columns of J belong to the interface.
    void restore(StateReader& state);

    /// Multiplies J, e.g. when the time step changes.
    void scale(double factor) { J_.scale(factor); }

  private:
    CouplingOptions options_;
    LowRankMatrix J_;
    LowRankMatrix atBegin_; ///< J, restored if the step is rejected
    LowRankMatrix taught_;  ///< 1 - P
};

} // namespace tokay::coupling
