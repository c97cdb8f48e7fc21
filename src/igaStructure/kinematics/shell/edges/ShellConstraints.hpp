// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgeSpring.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

using ShellPatches = std::vector<std::unique_ptr<ShellPatch>>;

/// What holds a shell and joins its patches.
struct ShellConstraints {
    std::vector<bool> fixed;     ///< unknowns that are zero: exact supports, and nodes without body
    std::vector<bool> supported; ///< those fixed by supports
    std::vector<std::unique_ptr<EdgeSpring>> springs;
    int nJoints = 0; ///< edges at which patches are joined
};

/// An edge along the side of a patch is held exactly, because the basis
/// interpolates there; a clamped one too where all normals of the edge are along one
/// axis of space, through the second row of control points. All else, and joints,
/// are springs.
/// @throws InputError if patches that are joined are apart
ShellConstraints shellConstraints(const ShellDescription& description, const ShellPatches& patches,
                                  int nNodes);

/// Rigid motions that are possible though unknowns are fixed and springs hold, in words.
std::vector<std::string> freeRigidMotions(const geometry::Points& nodes,
                                          const ShellConstraints& constraints);

} // namespace tokay::structure
