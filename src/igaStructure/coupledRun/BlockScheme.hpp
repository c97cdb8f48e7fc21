// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/BlockQuasiNewton.hpp"
#include "igaStructure/coupledRun/CouplingScheme.hpp"

namespace tokay::structure {

/// Solves the structure together with what is known of the fluid's response:
/// solving and accelerating are one. @see coupling::BlockQuasiNewton
class BlockScheme : public CouplingScheme {
  public:
    BlockScheme(const coupling::CouplingOptions& options, double tolerance, WetStructure& structure,
                const Eigen::VectorXd& initial, PhaseTimer& timer)
        : structure_(structure), timer_(timer), method_(options, tolerance, structure, initial) {}

    Eigen::VectorXd beginTimeStep(double deltaT) override { return method_.beginTimeStep(deltaT); }
    coupling::Iteration iterate(const std::vector<double>& forces, double fluidResidual) override {
        const Eigen::Map<const Eigen::VectorXd> onFaces(forces.data(), forces.size());
        return timer_.time(Phase::solving, [&] { return method_.iterate(onFaces, fluidResidual); });
    }
    Eigen::VectorXd finalAnswer(const std::vector<double>& forces) override {
        const Eigen::Map<const Eigen::VectorXd> onFaces(forces.data(), forces.size());
        const Eigen::VectorXd loads =
            timer_.time(Phase::solving, [&] { return method_.finalLoads(onFaces); });
        return structure_.answerTo(loads);
    }
    double acceptTimeStep(const Eigen::VectorXd&) override {
        return method_.acceptTimeStep(structure_.displacement());
    }
    void rejectTimeStep() override { method_.rejectTimeStep(); }
    const Eigen::VectorXd& x() const override { return method_.x(); }
    std::string name() const override { return "block"; }
    void save(coupling::StateWriter& state) const override { method_.save(state); }
    void restore(coupling::StateReader& state) override { method_.restore(state); }
    const coupling::StepStatistics& statistics() const override { return method_.statistics(); }

  private:
    WetStructure& structure_;
    PhaseTimer& timer_;
    coupling::BlockQuasiNewton method_;
};

} // namespace tokay::structure
