// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// What the structure's side returns for forces.
struct StructureResponse {
    Eigen::VectorXd displacements; ///< of the fluid's points [m]
    double residual = 1;           ///< of the coupling, to be below the fluid's tolerance
    bool converged = false;
    bool accepted = false;    ///< the step has ended
    std::string failure = {}; ///< why the step has no solution; empty: it has one
    std::optional<channel::InterfaceBalance> balance{}; ///< of an accepted step, if wanted
};

/// The structure's side of a coupled run, as the session with the fluid sees it.
class CoupledParticipant {
  public:
    virtual ~CoupledParticipant() = default;

    /// @return  predicted displacements of the fluid's points [m]
    virtual Eigen::VectorXd beginTimeStep(int step, double time, double deltaT) = 0;

    /// @param faceForces     on the fluid's faces, finite
    /// @param fluidResidual  initial residual of its momentum equation
    virtual StructureResponse iterate(const Eigen::VectorXd& faceForces,
                                      std::optional<double> fluidResidual) = 0;

    /// The step ends with these forces; or, if that is to be only when the residual is
    /// below the tolerance and it is not, they are those of another coupling iteration.
    /// @param final  on the fluid's faces, finite
    virtual StructureResponse acceptTimeStep(const channel::Forces& final) = 0;

    /// Writes the results of the accepted step: while the fluid goes on, or before it is told
    /// where it writes the time, from which both may start again. The state for that has been
    /// written by acceptTimeStep().
    virtual void finishTimeStep() = 0;

    /// Takes the step back; it begins again, shorter.
    virtual void rejectTimeStep() = 0;

    /// Removes saved states that a restart from none of the fluid's times would take.
    /// @param fluidTimes  that the fluid has on disk [s]
    virtual void removeStatesExcept(const std::vector<double>& fluidTimes) = 0;
};

} // namespace tokay::structure
