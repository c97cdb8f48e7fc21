// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/SupportLoad.hpp"
#include "igaStructure/kinematics/shell/edges/EdgeCoupling.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

#include <memory>
#include <vector>

namespace tokay::structure {

using ShellPatches = std::vector<std::unique_ptr<ShellPatch>>;

/// A support of a trimming curve that DirichletExtension imposes.
struct TrimmedSupport {
    geometry::BrepTrim trim;
    std::array<bool, 3> fixed;
    bool clamped;
    SupportMotion motion;
    int number;                    ///< of the support, as in SupportOwners
    std::vector<EdgePoint> points; ///< of its side of the edge
};

/// Constraints of a shell: supports and joints between patches.
struct ShellConstraints {
    std::vector<bool> fixed;     ///< unknowns that are zero: exact supports, and nodes without body
    std::vector<bool> supported; ///< those fixed by supports
    SupportTrace trace;          ///< of exact supports that move
    std::vector<TrimmedSupport> trimmedSupports; ///< of EdgeMethod::egm
    std::vector<std::unique_ptr<EdgeCoupling>> couplings;
    /// Couplings, by their numbers, that hold what a support moves.
    struct Moved {
        std::size_t coupling;
        SupportMotion motion;
    };
    std::vector<Moved> moved;
    /// Support of each unknown: edges, then points.
    SupportOwners owners;
    /// Support of each coupling; -1: none.
    std::vector<int> couplingOwners;
    int nJoints = 0; ///< edges at which patches are joined
};

/// An edge along the side of a patch is held exactly, because the basis
/// interpolates there; a clamped one too where all normals of the edge are along one
/// axis of space, through the second row of control points. All else, and joints,
/// are couplings.
/// @throws InputError if patches that are joined are apart
ShellConstraints shellConstraints(const ShellDescription& description, const ShellPatches& patches,
                                  int nNodes);

} // namespace tokay::structure
