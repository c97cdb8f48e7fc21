// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"

#include <vector>

namespace tokay::structure {

/// A location on an edge and the length it stands for [m].
struct EdgePiece {
    const PatchLocation* place;
    double length;
};

/// Components of the motion that are constrained along an edge.
struct HeldMotion {
    bool displacement, rotation;
    bool bending; ///< false: a membrane, of which only the displacement in its plane counts
};

/// Stiffnesses b of the tractions that an element exerts on a piece of edge: the sum of
/// traction^2 / b, integrated along the edge, is no larger than twice the element's
/// energy, once of membrane forces, once of all tractions of bending together.
struct TractionBounds {
    double membrane = 0; ///< [N/m^2]
    double shear = 0;    ///< of the normal displacement [N/m^2]
    double twist = 0;    ///< of its derivative along the edge [N]
    double moment = 0;   ///< of the rotation about the edge [N]

    void enlarge(const TractionBounds& other);
};

/// Smallest bounds of an element, from its eigenvalues. The element is taken as nearly flat:
/// what displacement in its plane bends, and displacement across it stretches, is left
/// out.
/// Source: Embar, Dolbow & Harari 2010, section 4
/// @param element  whose functions are taken, beyond its rim too; with quadrature points
TractionBounds tractionBounds(const ShellPatch& patch, int element,
                              const std::vector<EdgePiece>& edge, const HeldMotion& held);

} // namespace tokay::structure
