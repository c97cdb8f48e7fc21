#pragma once

#include "coupling/Accelerator.hpp"
#include "coupling/CouplingOptions.hpp"
#include "coupling/FilteredQr.hpp"

#include <deque>

namespace tokay::coupling {

/// Interface quasi-Newton with an approximation of the inverse Jacobian from a
/// least-squares model:  x = xTilde + W c,  c minimising |V c + residual|,
/// where V and W hold differences of the residual and of xTilde, newest first,
/// of this step and of reusedTimeSteps earlier ones.
///
/// In a fluid that has not converged the differences also carry its own drift;
/// the guards (signalToNoise, largestStep, keepFraction) keep that out.
/// Source: Degroote, Bathe & Vierendeels 2009, Performance of a new partitioned
/// procedure versus a monolithic procedure in fluid–structure interaction.
class IqnIls : public Accelerator {
  public:
    explicit IqnIls(const CouplingOptions& options);

    void beginTimeStep() override;
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                         double fluidResidual) override;
    void acceptTimeStep() override;
    void rejectTimeStep() override;
    int nColumns() const override { return model_.V.nColumns(); }

  private:
    struct Column {
        Eigen::VectorXd w; ///< difference of xTilde
        int step;
    };
    struct Model {
        FilteredQr V;
        std::deque<Column> W; ///< beside the columns of V
        void remove(int column);
        void removeOldest() { remove(V.nColumns() - 1); }
    };
    struct Exchange {
        Eigen::VectorXd x;
        Eigen::VectorXd xTilde;
    };

    void learn(const Exchange& now, double fluidResidual);
    Eigen::VectorXd quasiNewtonStep(const Exchange& now) const;

    CouplingOptions options_;
    Model model_;
    Model modelAtBegin_; ///< restored if the step is rejected
    Exchange previous_;  ///< empty: first exchange of the step
    int step_ = 0;
};

} // namespace tokay::coupling
