// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/caseEntryTables.hpp"

namespace tokay::structure {

using namespace casePresence;

namespace {
constexpr auto edges = "left right bottom top";
constexpr auto faces = "left right bottom top back front";
} // namespace

// clang-format off
const std::vector<CaseEntry>& modelEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"model", Kind::map, required, "", "", "", 0,
     "The mechanical model."},
    {"model.kinematics", Kind::word, required, "", "", "planeStrain planeStress beam cable shell membrane solid", 0,
     "planeStrain: a slice of a long body, forces per unit depth. planeStress: a thin plate in its plane. beam: Euler-Bernoulli beam without rotational unknowns, in the plane, or in space: straight, bending alike in all directions, without torsion. cable: a line that does not bend, in the plane or in space. shell: Kirchhoff-Love shell in space, without rotational unknowns. membrane: a shell that does not bend. solid: a volume in space."},
    {"model.strains", Kind::word, required, "", "", "linear nonlinear", 0,
     "linear: small strains and rotations. nonlinear: Green-Lagrange strains, any rotation (total Lagrangian)."},
    {"model.thickness", Kind::number, optional, "", "m", "(0, inf)", 0,
     "Of the plate with planeStress, of the beam or cable in its plane, of the shell or membrane, or of a solid that is given by its middle surface; not allowed with planeStrain."},
    {"model.faceThickness", Kind::mapList, defaulted, "[]", "", "", 0,
     "shell, membrane: faces of another thickness."},
    {"model.faceThickness[].face", Kind::text, required, "", "", "", 0,
     "Name of the face."},
    {"model.faceThickness[].thickness", Kind::number, required, "", "m", "(0, inf)", 0,
     "Its thickness."},
    {"model.faceMaterial", Kind::mapList, defaulted, "[]", "", "", 0,
     "shell, membrane: faces of another stiffness and density."},
    {"model.faceMaterial[].face", Kind::text, required, "", "", "", 0,
     "Name of the face."},
    {"model.faceMaterial[].youngsModulus", Kind::number, required, "", "Pa", "(0, inf)", 0,
     "Its Young's modulus."},
    {"model.faceMaterial[].density", Kind::number, required, "", "kg/m^3", "(0, inf)", 0,
     "Its density."},
    {"model.edgeMethod", Kind::word, optional, "", "", "penalty nitsche lagrange", 0,
     "shell, membrane: how patches are joined and edges held where the basis cannot do it exactly. penalty: springs. nitsche: tractions with just enough springs (linear strains). lagrange: multipliers along the edge. If not given: penalty if the entry penalty is given, with scheme explicit, and for membranes with nonlinear strains; else nitsche with linear strains, lagrange with nonlinear ones. nitsche needs StVenantKirchhoff in a shell; linear strains of others take lagrange."},
    {"model.penalty", Kind::number, optional, "", "", "(0, inf)", 0,
     "shell, membrane: penalty, lagrange: stiffness of the springs at joints and weak supports over that of an element, E t/((1 - nu^2) h) for displacements and E t^3/(12 (1 - nu^2) h) for angles; 1e3 and 1e6 if not given. nitsche: factor on the springs, 1 if not given."},
    {"model.sliverTreatment", Kind::word, optional, "", "", "scaling extension", 0,
     "shell, membrane: what is done about elements of which trimming leaves less than a fifth. scaling: unknowns are scaled by the diagonal of the stiffness, as always. extension: their polynomials are tied to those of a whole neighbour, too. extension if not given; with scheme explicit, where it is not possible, scaling."},
    {"model.width", Kind::number, optional, "", "m", "(0, inf)", 0,
     "beam, cable: extent of the rectangular section across the plane, on which forces per unit depth act; 1 if not given. In space: the thickness if not given, and a beam allows no other (a square)."},
    {"model.section", Kind::word, optional, "", "", "planeStrain planeStress", 0,
     "beam, cable: how the section strains across the plane. planeStrain: not at all, modulus E/(1 - nu^2) (a strip of a wide plate; a beam's if not given). planeStress: freely, modulus E (a rod; a cable's if not given, and the only one in space)."},
    {"model.rotaryInertia", Kind::yesNo, optional, "", "", "", 0,
     "beam with linear strains: include the inertia of the section's rotation; no if not given."},
    {"model.prestress", Kind::number, optional, "", "Pa", "", 0,
     "cable: axial stress in the reference configuration, tension positive; membrane: stress in all its directions; 0 if not given."},

    {"material", Kind::map, required, "", "", "", 0,
     "The material."},
    {"material.type", Kind::word, required, "", "", "StVenantKirchhoff neoHookean incompressibleNeoHookean", 0,
     "StVenantKirchhoff: linear relation of second Piola-Kirchhoff stress and Green-Lagrange strain (Hooke's law if strains are linear). Of shells, membranes and solids also neoHookean; of shells and membranes also incompressibleNeoHookean."},
    {"material.youngsModulus", Kind::number, required, "", "Pa", "(0, inf)", 0,
     "Young's modulus."},
    {"material.poissonsRatio", Kind::number, optional, "", "", "(-1, 0.5)", 0,
     "Poisson's ratio; required but for incompressibleNeoHookean, whose is 0.5."},
    {"material.density", Kind::number, required, "", "kg/m^3", "(0, inf)", 0,
     "Density in the reference configuration."},
    {"material.rayleighDamping", Kind::map, defaulted, "{}", "", "", 0,
     "Damping matrix C = mass M + stiffness K, K being the tangent of the undeformed body."},
    {"material.rayleighDamping.mass", Kind::number, defaulted, "0", "1/s", "[0, inf)", 0,
     "Factor of the mass matrix."},
    {"material.rayleighDamping.stiffness", Kind::number, defaulted, "0", "s", "[0, inf)", 0,
     "Factor of the stiffness matrix."},

    {"supports", Kind::mapList, required, "", "", "", 0,
     "Supports; an empty list [] leaves the body free."},
    {"supports[].edge", Kind::word, optional, "", "", edges, 0,
     "Edge of a plane solid, or of a shell or membrane of one patch, that is held."},
    {"supports[].faces", Kind::words, optional, "", "", faces, 0,
     "solid: face that is held; of two the edge, of three the corner at which they meet."},
    {"supports[].end", Kind::word, optional, "", "", "start end", 0,
     "End of a beam or cable that is held."},
    {"supports[].brepEdge", Kind::text, optional, "", "", "", 0,
     "shell, membrane: name of the edge of the model that is held."},
    {"supports[].point", Kind::numbers, optional, "", "m", "", 3,
     "shell, membrane: place of the surface that is held."},
    {"supports[].weak", Kind::yesNo, optional, "", "", "", 0,
     "shell, membrane: hold by springs where the basis could do it exactly, too; no if not given."},
    {"supports[].fix", Kind::words, required, "", "", "x y z rotation", 0,
     "What is zero there (exactly: the basis interpolates): displacement components; rotation of a beam's end (in space about both axes across it), also while it moves and however much."},

    {"loads", Kind::mapList, defaulted, "[]", "", "", 0,
     "Loads of the structure's own; each item has either edge and traction, or gravity; of a beam or cable: end with force and moment, or traction, or gravity, or pressure; of a solid: face with traction or pressure, or gravity."},
    {"loads[].edge", Kind::word, optional, "", "", edges, 0,
     "Edge of a plane solid, or of a shell or membrane of one patch, that is loaded."},
    {"loads[].traction", Kind::formulas, optional, "", "Pa", "", 0,
     "Force per reference area along x and y (in space: and z), on the edge or all along a beam; of a shell or membrane on its surface, of a solid on a face, along x, y and z; it keeps its direction as the body deforms."},
    {"loads[].end", Kind::word, optional, "", "", "start end", 0,
     "End of a beam or cable that is loaded."},
    {"loads[].force", Kind::formulas, optional, "", "N", "", 0,
     "Force at the end of a beam along x and y (in space: and z), on the whole width, or at a point of a shell; it keeps its direction."},
    {"loads[].moment", Kind::formula, optional, "", "N m", "", 0,
     "Moment at the end of a beam in the plane, counter-clockwise, on the whole width."},
    {"loads[].pressure", Kind::formula, optional, "", "Pa", "", 0,
     "Pressure on the left side of a beam or cable in the plane, seen along it; it stays normal to the axis and acts on the current length (linear strains: on the reference). shell, membrane: along its normal. solid: onto the face, on its current area."},
    {"loads[].brepEdge", Kind::text, optional, "", "", "", 0,
     "shell, membrane: name of the edge of the model that is loaded."},
    {"loads[].face", Kind::text, optional, "", "", "", 0,
     "Name of the face on which traction or pressure act. shell, membrane: all if not given. solid: left, right, bottom, top, back or front."},
    {"loads[].point", Kind::numbers, optional, "", "m", "", 3,
     "shell, membrane: place of the surface at which the force acts."},
    {"loads[].lineForce", Kind::formulas, optional, "", "N/m", "", 3,
     "shell, membrane: force per reference length on the edge; it keeps its direction."},
    {"loads[].lineMoment", Kind::formula, optional, "", "N", "", 0,
     "shell: moment per reference length about the edge; positive turns the normal outwards across it."},
    {"loads[].gravity", Kind::formulas, optional, "", "m/s^2", "", 0,
     "Acceleration along x and y (in space: and z) that acts on the mass."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
