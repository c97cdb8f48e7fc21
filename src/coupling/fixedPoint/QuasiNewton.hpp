// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/Accelerator.hpp"
#include "coupling/history/FilteredQr.hpp"
#include "coupling/step/InitialRelaxation.hpp"

namespace tokay::coupling {

/// Options that the interface quasi-Newton methods share; the last three guard against a
/// fluid that has not converged.
struct QuasiNewtonOptions : InitialRelaxation, FilterOptions {
    double signalToNoise = 3;
    double maxStep = 2;
    double keepFraction = 0.05;

    static const SchemaOf<QuasiNewtonOptions>& schema();
};

/// What the interface quasi-Newton methods share: x + residual - J residual,
/// where J ≈ d xTilde / d residual is learned from differences between the
/// coupling iterations of a step (V of the residual, W of xTilde).
///
/// In a fluid that has not converged the differences also carry its own drift;
/// the guards (signalToNoise, maxStep, keepFraction) keep that out.
class QuasiNewton : public Accelerator {
  public:
    explicit QuasiNewton(const QuasiNewtonOptions& options) : options_(options) {}

    void beginTimeStep() override { previous_ = {}; }
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                         double fluidResidual) final;

  protected:
    /// Takes a pair of differences, v of the residual and w of xTilde.
    virtual void learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w) = 0;

    /// Nothing has been learned yet: relax instead.
    virtual bool isEmpty() const = 0;

    /// J residual
    virtual Eigen::VectorXd response(const Eigen::VectorXd& residual) const = 0;

  private:
    struct Iterate {
        Eigen::VectorXd x;
        Eigen::VectorXd xTilde;
    };

    bool isInformative(const Iterate& now, double fluidResidual) const;
    void limit(Eigen::VectorXd& move, double residualNorm) const;

    QuasiNewtonOptions options_;
    Iterate previous_; ///< empty: first coupling iteration of the step
};

} // namespace tokay::coupling
