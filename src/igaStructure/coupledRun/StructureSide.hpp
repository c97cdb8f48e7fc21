// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Answer of the structure's side to forces.
struct Answer {
    Eigen::VectorXd displacements; ///< of the fluid's points [m]
    double residual = 1;           ///< of the coupling, to be below the fluid's tolerance
    bool converged = false;
    std::string failure = {}; ///< the step has no solution, because of this; empty: it has
    std::optional<channel::InterfaceBalance> balance{}; ///< of an accepted step, if wanted
};

/// The structure as a coupled run sees it.
class StructureSide {
  public:
    virtual ~StructureSide() = default;

    /// @return  predicted displacements of the fluid's points [m]
    virtual Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) = 0;

    /// @param forces         on the fluid's faces
    /// @param fluidResidual  initial residual of its momentum equation
    virtual Answer iterate(const std::vector<double>& forces, double fluidResidual) = 0;

    /// The step ends with these forces.
    /// @param writeResults  now
    virtual Answer acceptTimeStep(const std::vector<double>& forces, bool writeResults) = 0;

    /// The step counts for nothing; it begins again, shorter.
    virtual void rejectTimeStep() = 0;
};

} // namespace tokay::structure
