// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/history/LowRankMatrix.hpp"
#include "coupling/step/StepHistory.hpp"

#include <optional>
#include <vector>

namespace tokay::coupling {

struct ResponseOptions : RankOptions {
    double filterLimit = 0.01;

    static const SchemaOf<ResponseOptions>& schema() {
        static const SchemaOf<ResponseOptions> schema =
            SchemaOf<ResponseOptions>()
                .with(RankOptions::schema())
                .with(SchemaOf<ResponseOptions>{
                    {"filterLimit", &ResponseOptions::filterLimit, "[0, 1)", "",
                     "Minimum noise of a difference relative to its length."}});
        return schema;
    }
};

/// A Jacobian J learned from noisy differences v -> w and carried from step to
/// step. P, the identity at the start of a step, says in which directions of v
/// the step has observed nothing yet; a difference whose noise is λ, in units of
/// v, enters as
///   J += (w - J v) gᵀ,  P -= P v gᵀ,  g = P v / (vᵀ P v + λ²).
/// Without noise that is the multi-vector method: of all matrices that satisfy
/// the differences of the step the nearest to the last step's. J is compressed
/// whenever its rank exceeds maxRank, so that time and memory stay bounded.
/// Source: Ljung 1999, System Identification, 2nd edition, section 11.2
/// (recursive least squares as a Kalman filter).
class ResponseModel : public StepHistory {
  public:
    /// Uses filterLimit, the least noise of a difference over the part of it that
    /// the step has observed already, and maxRank, rankLimit.
    explicit ResponseModel(const ResponseOptions& options) : options_(options) {}

    void beginTimeStep() override;

    void learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w, double noise);

    /// Nothing has been learned yet: J is zero.
    bool isEmpty() const { return J_.rank() == 0; }

    const LowRankMatrix& matrix() const { return J_; }

    /// Learns anew: J is zero, unless the step is rejected.
    void reset();

    void acceptTimeStep() override;
    void rejectTimeStep() override;
    void save(StateWriter& state) const override { J_.save(state); }
    void restore(StateReader& state) override {
        J_.restore(state, LowRankMatrix::Rows::ofStructure);
    }

    /// Before a step of another length: J as if all of it were the fluid's inertia, whose
    /// forces belong to accelerations and so go as x / Δt². Forces by velocity go as
    /// x / Δt, by displacement as x, and at a change a multistep scheme differs: the
    /// differences of the step then rescale J by the factor that fits them best.
    /// @param ratio  earlier over new length
    void changeTimeStep(double ratio);

  private:
    struct Difference {
        Eigen::VectorXd v;
        Eigen::VectorXd w;
        double noise;
    };

    void add(const Difference& difference);
    const LowRankMatrix& atBegin();
    double bestFactor();

    ResponseOptions options_;
    LowRankMatrix J_;
    int rankAtBegin_ = 0;                  ///< a step appends to J
    std::optional<LowRankMatrix> atBegin_; ///< J at the step's begin; none: J has its columns yet
    LowRankMatrix observed_;               ///< 1 - P
    double scaledBy_ = 1;                  ///< since the last accepted step
    double scaledByAtBegin_ = 1;
    std::vector<Difference> differences_; ///< of the step, if it is of another length
};

} // namespace tokay::coupling
