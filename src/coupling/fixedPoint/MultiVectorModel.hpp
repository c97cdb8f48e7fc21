// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/QuasiNewton.hpp"
#include "coupling/history/LowRankMatrix.hpp"
#include "coupling/step/StepHistory.hpp"

#include <deque>

namespace tokay::coupling {

struct MultiVectorOptions : QuasiNewtonOptions, RankOptions {
    static const SchemaOf<MultiVectorOptions>& schema() {
        static const SchemaOf<MultiVectorOptions> schema = SchemaOf<MultiVectorOptions>()
                                                               .with(RankOptions::schema())
                                                               .with(QuasiNewtonOptions::schema());
        return schema;
    }
};

/// A Jacobian learned from differences v -> w and carried from step to step:
///   J = Jₙ + (W - Jₙ V) R⁻¹ Qᵀ,  V = Q R the differences of this step,
/// of all matrices that satisfy J V = W the nearest to Jₙ, the one accepted in
/// the last step. Jₙ is kept as a product of low rank, compressed whenever it
/// exceeds maxRank, so that time and memory stay bounded.
/// Source: Lindner, Mehl, Scheufele & Uekermann 2015, A comparison of various
/// quasi-Newton schemes for partitioned fluid–structure interaction; restart
/// by singular values: Scheufele & Mehl 2017, Robust multisecant quasi-Newton
/// variants for parallel fluid–structure simulations.
class MultiVectorModel : public StepHistory {
  public:
    /// Uses filter, filterLimit, keepFraction, maxRank, rankLimit.
    explicit MultiVectorModel(const MultiVectorOptions& options);

    /// Takes the pair v -> w, of this step.
    void learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w);

    /// Nothing has been learned yet: J is zero.
    bool isEmpty() const { return old_.rank() == 0 && columns_.empty(); }

    /// J v, of nRows components.
    Eigen::VectorXd apply(const Eigen::VectorXd& v, Eigen::Index nRows) const;

    /// J as a product.
    LowRankMatrix matrix() const;

    /// Makes Jₙ of J, without the small columns of this step.
    void acceptTimeStep() override;
    void rejectTimeStep() override;
    void save(StateWriter& state) const override { old_.save(state); }
    void restore(StateReader& state) override {
        old_.restore(state, LowRankMatrix::Rows::ofInterface);
    }

    int nColumns() const { return static_cast<int>(columns_.size()); }
    int rank() const { return old_.rank() + nColumns(); }

  private:
    struct Column {
        Eigen::VectorXd correction; ///< w - Jₙ v
        double norm;                ///< of w
    };

    LowRankMatrix update() const;

    MultiVectorOptions options_;
    LowRankMatrix old_; ///< Jₙ
    FilteredQr V_;
    std::deque<Column> columns_; ///< beside those of V
};

} // namespace tokay::coupling
