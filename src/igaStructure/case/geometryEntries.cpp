// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/caseEntryTables.hpp"

namespace tokay::structure {

using namespace casePresence;

// clang-format off
const std::vector<CaseEntry>& geometryEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"name", Kind::text, optional, "", "", "", 0,
     "Name of the case in the names of results; the case file's name without .yaml if not given."},

    {"geometry", Kind::map, required, "", "", "", 0,
     "The body in its reference configuration; exactly one of the shapes below."},
    {"geometry.slit", Kind::yesNo, defaulted, "no", "", "", 0,
     "no: edges that coincide are joined: opposite sides of a body that is closed in itself (a pipe, a ring), and edges of different patches, also where a cad.json does not say that they share one. yes: they stay open, but for the edges that a cad.json shares."},
    {"geometry.rectangle", Kind::map, optional, "", "", "", 0,
     "Rectangle parallel to the axes; its edges left, right, bottom, top are where one sees them."},
    {"geometry.rectangle.origin", Kind::numbers, required, "", "m", "", 2,
     "Lower left corner."},
    {"geometry.rectangle.size", Kind::numbers, required, "", "m", "(0, inf)", 2,
     "Extent along x and y."},
    {"geometry.line", Kind::map, optional, "", "", "", 0,
     "Straight axis of a beam or cable."},
    {"geometry.line.from", Kind::numbers, required, "", "m", "", 0,
     "Where it starts, [x, y], or [x, y, z]: a line with a z, be it 0, is in space."},
    {"geometry.line.to", Kind::numbers, required, "", "m", "", 0,
     "Where it ends, likewise."},
    {"geometry.arc", Kind::map, optional, "", "", "", 0,
     "Circular axis of a beam in the plane (up to a quarter turn) or of a cable, parallel to the plane of x and y."},
    {"geometry.arc.centre", Kind::numbers, required, "", "m", "", 0,
     "Centre of the circle, [x, y], or [x, y, z]: in space."},
    {"geometry.arc.radius", Kind::number, required, "", "m", "(0, inf)", 0,
     "Its radius."},
    {"geometry.arc.angles", Kind::numbers, required, "", "degrees", "", 2,
     "Where it starts and ends, counter-clockwise from the x axis; the end is the larger one."},
    {"geometry.plate", Kind::map, optional, "", "", "", 0,
     "Flat parallelogram in space; left and right are its first and last xi, bottom and top its first and last eta."},
    {"geometry.plate.origin", Kind::numbers, required, "", "m", "", 3,
     "Corner at which both edges start."},
    {"geometry.plate.edgeXi", Kind::numbers, required, "", "m", "", 3,
     "From there along xi."},
    {"geometry.plate.edgeEta", Kind::numbers, required, "", "m", "", 3,
     "From there along eta."},
    {"geometry.cylinder", Kind::map, optional, "", "", "", 0,
     "Part of a cylinder around an axis along z; xi runs along the angle, eta along z, the normal points outwards."},
    {"geometry.cylinder.base", Kind::numbers, required, "", "m", "", 3,
     "Point of the axis at its bottom."},
    {"geometry.cylinder.radius", Kind::number, required, "", "m", "(0, inf)", 0,
     "Its radius."},
    {"geometry.cylinder.height", Kind::number, required, "", "m", "(0, inf)", 0,
     "Its height."},
    {"geometry.cylinder.angles", Kind::numbers, required, "", "degrees", "", 2,
     "Where it starts and ends, counter-clockwise from the x axis; the end is the larger one."},
    {"geometry.block", Kind::map, optional, "", "", "", 0,
     "Box parallel to the axes (solid); left and right are its first and last x, bottom and top its first and last y, back and front its first and last z."},
    {"geometry.block.origin", Kind::numbers, required, "", "m", "", 3,
     "Corner with the least coordinates."},
    {"geometry.block.size", Kind::numbers, required, "", "m", "(0, inf)", 3,
     "Extent along x, y and z."},
    {"geometry.cadJson", Kind::text, optional, "", "", "", 0,
     "File of trimmed patches and their edges (shell, membrane), relative to the case file; patches are joined along edges that they share or that coincide (slit). The normal of a face with swapped_surface_normal is reversed, and its xi with it."},
    {"geometry.nurbs", Kind::map, optional, "", "", "", 0,
     "A NURBS curve (beam, cable), patch or volume (solid); left and right are its first and last xi, bottom and top its first and last eta, back and front its first and last zeta. A solid given by a surface lies half its thickness on either side; zeta is along the normal."},
    {"geometry.nurbs.degree", Kind::integers, required, "", "", "[1, 10]", 0,
     "Degree along xi and, of a surface, eta, of a volume, zeta."},
    {"geometry.nurbs.knotsXi", Kind::numbers, required, "", "", "", 0,
     "Open knot vector along xi."},
    {"geometry.nurbs.knotsEta", Kind::numbers, optional, "", "", "", 0,
     "Open knot vector along eta of a surface or volume."},
    {"geometry.nurbs.knotsZeta", Kind::numbers, optional, "", "", "", 0,
     "Open knot vector along zeta of a volume."},
    {"geometry.nurbs.controlPoints", Kind::points, required, "", "m", "", 0,
     "Control points, xi running fastest, then eta; z is 0 if not given. A beam or cable of which one has a z, be it 0, is in space."},
    {"geometry.nurbs.weights", Kind::numbers, optional, "", "", "(0, inf)", 0,
     "One weight a control point; all 1 if not given."},

    {"discretisation", Kind::map, required, "", "", "", 0,
     "The basis of the displacement: the geometry's own, refined."},
    {"discretisation.degree", Kind::integers, required, "", "", "[1, 10]", 0,
     "Degree along xi and, of a surface, eta, of a solid, zeta; not below the geometry's. A beam needs 2; its shear force 3."},
    {"discretisation.elements", Kind::integers, required, "", "", "[1, 100000]", 0,
     "Parts into which each knot span of the geometry is cut, along xi and, of a surface, eta, of a solid, zeta."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
