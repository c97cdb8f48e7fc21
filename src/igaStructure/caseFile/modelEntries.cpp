#include "igaStructure/caseFile/caseEntryTables.hpp"

namespace tokay::structure {

using namespace casePresence;

namespace {
constexpr auto edges = "left right bottom top";
} // namespace

// clang-format off
const std::vector<CaseEntry>& modelEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"model", Kind::map, required, "", "", "", 0,
     "The mechanical model."},
    {"model.kinematics", Kind::word, required, "", "", "planeStrain planeStress", 0,
     "planeStrain: a slice of a long body, forces per unit depth. planeStress: a thin plate in its plane."},
    {"model.strains", Kind::word, required, "", "", "linear nonlinear", 0,
     "linear: small strains and rotations. nonlinear: Green-Lagrange strains, any rotation (total Lagrangian)."},
    {"model.thickness", Kind::number, optional, "", "m", "(0, inf)", 0,
     "Thickness of the plate; required with planeStress, not allowed with planeStrain."},

    {"material", Kind::map, required, "", "", "", 0,
     "The material."},
    {"material.type", Kind::word, required, "", "", "StVenantKirchhoff", 0,
     "StVenantKirchhoff: linear relation of second Piola-Kirchhoff stress and Green-Lagrange strain (Hooke's law if strains are linear)."},
    {"material.youngsModulus", Kind::number, required, "", "Pa", "(0, inf)", 0,
     "Young's modulus."},
    {"material.poissonsRatio", Kind::number, required, "", "", "(-1, 0.5)", 0,
     "Poisson's ratio."},
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
     "Edge that is held."},
    {"supports[].fix", Kind::words, required, "", "", "x y", 0,
     "Displacement components that are zero on the edge (exactly: the basis interpolates there)."},

    {"loads", Kind::mapList, defaulted, "[]", "", "", 0,
     "Loads of the structure's own; each item has either edge and traction, or gravity."},
    {"loads[].edge", Kind::word, optional, "", "", edges, 0,
     "Edge that is loaded."},
    {"loads[].traction", Kind::formulas, optional, "", "Pa", "", 0,
     "Force per reference area along x and y; it keeps its direction as the body deforms."},
    {"loads[].gravity", Kind::formulas, optional, "", "m/s^2", "", 0,
     "Acceleration along x and y that acts on the mass."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
