// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"
#include "igaStructure/case/Case.hpp"
#include "igaStructure/coupledRun/restart/StateFolder.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// Where a coupled run restarts from.
struct StartState {
    SavedState saved;
    /// For each component of the interface now its number in the saved state;
    /// empty if the fluid's mesh at the interface is another one.
    std::vector<int> components;
};

/// Where the saved states of a case are.
StateFolder stateFolder(const Case& structureCase);

/// @throws InputError if a saved state is that of another geometry or discretisation
void requireSameStructure(const SavedState& state, const Case& structureCase, int nUnknowns);

/// The saved state that belongs to the fluid's fields at its start time; none
/// if the fluid starts from an undeformed mesh, and so the structure at rest.
/// @param points  of the fluid's interface in the reference configuration, n x 3 [m]
/// @throws InputError if the fluid is deformed and no such state is found
std::optional<StartState> findStartState(const Case& structureCase, int nUnknowns,
                                         const geometry::Points& points,
                                         const channel::Interface& fluid);

/// Compares the structure's displacement with the interface's that was saved beside
/// it; not on another mesh of the fluid.
/// @param mapped  the structure's at the fluid's points, as numbered now [m]
/// @throws InputError that names the file
void requireConsistent(const StartState& state, const Eigen::VectorXd& mapped);

} // namespace tokay::structure
