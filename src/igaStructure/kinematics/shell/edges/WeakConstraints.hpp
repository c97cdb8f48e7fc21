// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgeCoupling.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

#include <array>
#include <memory>
#include <vector>

namespace tokay::structure {

using EdgeCouplings = std::vector<std::unique_ptr<EdgeCoupling>>;

/// Moves couplings to the end of others.
void append(EdgeCouplings added, EdgeCouplings& couplings);

/// Holds weakly, by the description's method (penalty, Nitsche or multipliers): joints,
/// and supports where the basis interpolates nothing.
class WeakConstraints {
  public:
    /// @param description  is borrowed
    /// @throws InputError if its method is not for its strains or material
    explicit WeakConstraints(const ShellDescription& description);

    /// Of a face.
    struct Stiffness {
        double membrane; ///< E t / (1 - nu^2) [N/m]
        double bending;  ///< E t^3 / 12 / (1 - nu^2) [N m]; 0: a membrane
    };
    Stiffness stiffness(int face) const;

    /// Holds an edge, or joins two faces along it. Across an edge inside of a patch tractions
    /// jump, so Nitsche's method has none to take there.
    /// @param components  of the displacement that are held
    /// @param rotation    whether the rotation about the edge is held
    /// @param faces       of both sides; twice the same: a support
    /// @param trims       whether the edge bounds all of these patches
    void holdEdge(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                  bool rotation, const std::array<int, 2>& faces, bool trims,
                  EdgeCouplings& couplings) const;

    /// Holds the angle at knot lines where the functions of a patch have a kink. Both sides
    /// have the same functions there, so springs ask for no more than these can do.
    void holdCreases(const ShellPatch& patch, int face, EdgeCouplings& couplings) const;

    /// Holds components of the displacement of a point.
    void holdPoint(const PatchLocation& place, const std::array<bool, 3>& components, int face,
                   EdgeCouplings& couplings) const;

  private:
    void requirePossible() const;
    double factor(EdgeMethod method) const;

    const ShellDescription& description_;
    EdgeMethod method_;
};

} // namespace tokay::structure
