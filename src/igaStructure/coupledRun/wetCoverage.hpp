// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/InterfaceTransfer.hpp"
#include "mapper/loads/LoadPoints.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// A named part of a wet surface, and how much of it the fluid's faces reach.
struct WetPart {
    std::string name;
    double size = 0;    ///< length, in space area [m, m^2]
    double reached = 0; ///< of which some face covers [m, m^2]
};

/// Parts of the wet surface on which no force can act, because no face of the fluid lies
/// before them: a patch that was forgotten moves the answer without any other sign.
/// A place is reached if its projection falls inside a face that belongs to its part,
/// that is, whose centre is nearest to it. To the size of a quarter of a knot span.
std::vector<WetPart> wetCoverage(const WetSurface& wet, const mapper::FaceMesh& fluid);

/// Faces of the fluid whose corners lie on the wet surface, or at some distance from it,
/// but whose centre is farther away than that by a third of the face: they lie on a part of
/// the body that is not wet.
/// @throws InputError that gives the number of such faces and the place of one
void requireFacesOnBody(const WetSurface& wet, const mapper::FaceMesh& fluid);

/// The parts of which more than a twentieth is not reached, for the log: lines.
std::string describeUnreached(const std::vector<WetPart>& parts);

/// @throws InputError that names these parts, unless there is none
void requireReached(const std::vector<WetPart>& parts);

} // namespace tokay::structure
