// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/coupledRun/DisplacementRecord.hpp"
#include "igaStructure/coupledRun/StructureSide.hpp"
#include "igaStructure/run/StepReport.hpp"

namespace tokay::structure {

/// Answers recorded displacements whatever the forces are: shows how many
/// correctors the fluid alone needs.
class PrescribedStructure : public StructureSide {
  public:
    PrescribedStructure(DisplacementRecord record, Report report)
        : record_(std::move(record)), report_(std::move(report)) {}

    Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) override;
    Answer iterate(const std::vector<double>& forces, double fluidResidual) override;
    Answer acceptTimeStep(const std::vector<double>& forces, bool writeResults) override;
    void rejectTimeStep() override {}

  private:
    DisplacementRecord record_;
    Report report_;
    Eigen::VectorXd displacements_;
    double time_ = 0;
    int step_ = 0;
    int nExchanges_ = 0;
};

} // namespace tokay::structure
