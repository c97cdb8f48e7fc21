// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/Accelerator.hpp"

namespace tokay::coupling {

/// x + relaxation (xTilde - x), with a factor that follows from the last two
/// residuals; exact for one unknown that responds linearly.
/// Source: Küttler & Wall 2008, Fixed-point fluid–structure interaction
/// solvers with dynamic relaxation, eq. 44.
class Aitken : public Accelerator {
  public:
    /// Uses initialRelaxation, smallestRelaxation, largestRelaxation.
    explicit Aitken(const CouplingOptions& options);

    void beginTimeStep() override;
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                         double fluidResidual) override;
    void rejectTimeStep() override;
    void save(StateWriter& state) const override;
    void restore(StateReader& state) override;

    double relaxation() const { return relaxation_; }

  private:
    void updateRelaxation(const Eigen::VectorXd& residual);

    double initial_;
    double smallest_;
    double largest_;
    double relaxation_;
    Eigen::VectorXd previousResidual_; ///< empty: first coupling iteration of the step
    Eigen::VectorXd previousX_;        ///< that it belongs to
};

} // namespace tokay::coupling
