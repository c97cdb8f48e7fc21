// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/caseEntryTables.hpp"

namespace tokay::structure {

using namespace casePresence;

// clang-format off
const std::vector<CaseEntry>& outputEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"output", Kind::map, defaulted, "{}", "", "", 0,
     "Results."},
    {"output.directory", Kind::text, defaulted, "results", "", "", 0,
     "Where the .pvd and .vtu files go, relative to the case file."},
    {"output.interval", Kind::integer, defaulted, "10", "time steps", "[0, inf)", 0,
     "Run alone: time steps between two results; 0: none. A coupled run writes when the fluid writes."},
    {"output.fields", Kind::words, optional, "", "", "displacement velocity acceleration stress vonMisesStress principalStress normalForce bendingMoment shearForce axialStress membraneForce principalStressTop principalStressBottom", 0,
     "Fields of the .vtu files; stress is Cauchy's. If not given: displacement, velocity and: stress of a plane or other solid; normalForce [N], bendingMoment [N m] and shearForce [N] of a beam (in space their lengths); membraneForce [N/m] and bendingMoment [N] of a shell (11, 22, 12; axis 1 along the first parameter line). principalStressTop, principalStressBottom [Pa]: larger and smaller one at the faces of a shell, top being where the normal points. principalStress [Pa]: of a solid, descending."},
    {"output.cells", Kind::word, defaulted, "quads", "", "quads bezier", 0,
     "quads: each element cut into subdivision x subdivision flat cells (a solid: subdivision^3 hexahedra), for any reader. bezier: one exact (rational) Bezier cell an element (a beam's axis), for ParaView 5.8 or later."},
    {"output.subdivision", Kind::integer, defaulted, "4", "", "[1, 100]", 0,
     "Cells along each side of an element, with quads (one through the thickness of a beam; a line in space has pieces of its axis)."},
    {"output.watchPoints", Kind::mapList, defaulted, "[]", "", "", 0,
     "Points whose displacement is logged and tabulated each time step; the first one is shown in the log."},
    {"output.watchPoints[].name", Kind::text, required, "", "", "", 0,
     "Name of its columns."},
    {"output.watchPoints[].at", Kind::numbers, required, "", "m", "", 0,
     "Position [x, y] or [x, y, z] in the reference configuration."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
