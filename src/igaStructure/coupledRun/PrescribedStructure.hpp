// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/coupledRun/CoupledParticipant.hpp"
#include "igaStructure/coupledRun/DisplacementRecord.hpp"
#include "igaStructure/run/StepReport.hpp"

namespace tokay::structure {

/// Returns recorded displacements whatever the forces are: shows how many outer
/// correctors the fluid alone needs.
class PrescribedStructure : public CoupledParticipant {
  public:
    PrescribedStructure(DisplacementRecord record, Report report)
        : record_(std::move(record)), report_(std::move(report)) {}

    Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) override;
    StructureResponse iterate(const Eigen::VectorXd& faceForces,
                              std::optional<double> fluidResidual) override;
    StructureResponse acceptTimeStep(const channel::Forces&) override;
    void finishTimeStep() override;
    void rejectTimeStep() override {}
    void removeStatesExcept(const std::vector<double>& /*fluidTimes*/) override {}

  private:
    DisplacementRecord record_;
    Report report_;
    Eigen::VectorXd displacements_;
    double time_ = 0;
    int step_ = 0;
    int nExchanges_ = 0;
};

} // namespace tokay::structure
