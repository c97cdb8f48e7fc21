// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/Accelerator.hpp"
#include "coupling/step/CoupledStructure.hpp"
#include "coupling/step/CouplingMethod.hpp"
#include "coupling/step/CouplingOptions.hpp"

#include <memory>

namespace tokay::coupling {

/// Accelerated fixed-point iteration (block Gauß–Seidel): solves the structure for
/// the forces as they are, then accelerates from x and x̃.
///
/// Explicit coupling: iterate() returns x unchanged and converged, with the
/// residual 0, because that is not controlled.
class FixedPoint : public CouplingMethod {
  public:
    /// @param tolerance  of the fluid, relative; @see ConvergenceCriteria
    /// @param structure  is kept by reference
    /// @throws InputError if the tolerance is out of its range
    FixedPoint(const CouplingOptions& options, double tolerance, CoupledStructure& structure,
               std::unique_ptr<Accelerator> accelerator);

    const Eigen::VectorXd& predict(double deltaT) override;
    CouplingIteration iterate(const Eigen::VectorXd& faceForces,
                              std::optional<double> fluidResidual) override;
    CouplingIteration accept(const Eigen::VectorXd& finalForces,
                             double limit = std::numeric_limits<double>::infinity()) override;
    void reject() override;

    std::string name() const override { return "fixedPoint"; }
    void save(StateWriter& state) const override;
    /// The accelerator begins anew if the state is of another one.
    void restore(StateReader& state) override;
    const Eigen::VectorXd& x() const override { return x_; }

  private:
    const std::string acceleration_;
    CoupledStructure& structure_;
    ConvergenceCriteria criteria_;
    Predictor predictor_;
    std::unique_ptr<Accelerator> accelerator_;
    Eigen::VectorXd x_;    ///< of the last coupling iteration
    Eigen::VectorXd next_; ///< of the one to come
    double deltaT_ = 0;    ///< 0: no step is under way
};

} // namespace tokay::coupling
