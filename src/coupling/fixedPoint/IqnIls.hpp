// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/QuasiNewton.hpp"

#include <deque>

namespace tokay::coupling {

/// Interface quasi-Newton with an inverse Jacobian from a least-squares model:
/// J residual = W c,  c minimising |V c - residual|, with the differences of
/// this step and of reusedTimeSteps earlier ones, newest first.
/// Source: Degroote, Bathe & Vierendeels 2009, Performance of a new partitioned
/// procedure versus a monolithic procedure in fluid–structure interaction.
class IqnIls : public QuasiNewton {
  public:
    struct Options : QuasiNewtonOptions {
        int reusedTimeSteps = 15;
        int maxColumns = 30;

        static const SchemaOf<Options>& schema();
    };

    explicit IqnIls(const Options& options);

    void beginTimeStep() override;
    void acceptTimeStep() override;
    void rejectTimeStep() override;
    void save(StateWriter& state) const override;
    void restore(StateReader& state) override;
    int nColumns() const override { return model_.V.nColumns(); }

  protected:
    void learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w) override;
    bool isEmpty() const override { return model_.W.empty(); }
    Eigen::VectorXd response(const Eigen::VectorXd& residual) const override;

  private:
    struct Column {
        Eigen::VectorXd w;
        int step;
    };
    struct Model {
        FilteredQr V;
        std::deque<Column> W; ///< beside the columns of V
        void remove(int column);
        void removeOldest() { remove(V.nColumns() - 1); }
    };

    Options options_;
    Model model_;
    Model modelAtBegin_; ///< restored if the step is rejected
    int step_ = 0;
};

} // namespace tokay::coupling
