// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/coupledRun/CouplingScheme.hpp"

namespace tokay::structure {

/// Solves the structure for the forces as they are, then accelerates what it
/// answers.
class FixedPointScheme : public CouplingScheme {
  public:
    FixedPointScheme(const coupling::CouplingOptions& options, double tolerance,
                     WetStructure& structure, const Eigen::VectorXd& initial, PhaseTimer& timer)
        : structure_(structure), timer_(timer),
          driver_(options, tolerance, structure.displacements(initial)) {}

    Eigen::VectorXd beginTimeStep(double deltaT) override { return driver_.beginTimeStep(deltaT); }
    coupling::Iteration iterate(const std::vector<double>& forces, double fluidResidual) override {
        const Eigen::VectorXd xTilde = structure_.answer(forces);
        const Eigen::Map<const Eigen::VectorXd> onFaces(forces.data(), forces.size());
        return timer_.time(Phase::acceleration,
                           [&] { return driver_.iterate(xTilde, fluidResidual, onFaces); });
    }
    Eigen::VectorXd finalAnswer(const std::vector<double>& forces) override {
        return structure_.answer(forces);
    }
    double acceptTimeStep(const Eigen::VectorXd& xTilde) override {
        return driver_.acceptTimeStep(xTilde);
    }
    void rejectTimeStep() override { driver_.rejectTimeStep(); }
    const Eigen::VectorXd& x() const override { return driver_.x(); }
    std::string name() const override { return "fixedPoint"; }
    void save(coupling::StateWriter& state) const override { driver_.save(state); }
    void restore(coupling::StateReader& state) override { driver_.restore(state); }
    const coupling::StepStatistics& statistics() const override { return driver_.statistics(); }

  private:
    WetStructure& structure_;
    PhaseTimer& timer_;
    coupling::FixedPointDriver driver_;
};

} // namespace tokay::structure
