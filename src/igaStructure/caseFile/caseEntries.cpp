#include "igaStructure/caseFile/CaseEntry.hpp"

#include "coupling/CouplingOptions.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

constexpr auto required = Presence::required;
constexpr auto optional = Presence::optional;
constexpr auto defaulted = Presence::defaulted;

constexpr auto edges = "left right bottom top";

const coupling::CouplingOptions coupled;

std::string withDefault(const char* meaning, double value) {
    return fmt::format("{}; {:g} if not given.", meaning, value);
}

} // namespace

// clang-format off
const std::vector<CaseEntry>& caseEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"name", Kind::text, optional, "", "", "", 0,
     "Name of the case in the names of results; the case file's name without .yaml if not given."},

    {"geometry", Kind::map, required, "", "", "", 0,
     "The body in its reference configuration; exactly one of the shapes below."},
    {"geometry.rectangle", Kind::map, optional, "", "", "", 0,
     "Rectangle parallel to the axes; its edges left, right, bottom, top are where one sees them."},
    {"geometry.rectangle.origin", Kind::numbers, required, "", "m", "", 2,
     "Lower left corner."},
    {"geometry.rectangle.size", Kind::numbers, required, "", "m", "(0, inf)", 2,
     "Extent along x and y."},
    {"geometry.nurbs", Kind::map, optional, "", "", "", 0,
     "A NURBS patch; left and right are its first and last xi, bottom and top its first and last eta."},
    {"geometry.nurbs.degree", Kind::integers, required, "", "", "[1, 10]", 2,
     "Degree along xi and eta."},
    {"geometry.nurbs.knotsXi", Kind::numbers, required, "", "", "", 0,
     "Open knot vector along xi."},
    {"geometry.nurbs.knotsEta", Kind::numbers, required, "", "", "", 0,
     "Open knot vector along eta."},
    {"geometry.nurbs.controlPoints", Kind::points, required, "", "m", "", 0,
     "Control points, xi running fastest."},
    {"geometry.nurbs.weights", Kind::numbers, optional, "", "", "(0, inf)", 0,
     "One weight a control point; all 1 if not given."},

    {"discretisation", Kind::map, required, "", "", "", 0,
     "The basis of the displacement: the geometry's own, refined."},
    {"discretisation.degree", Kind::integers, required, "", "", "[1, 10]", 2,
     "Degree along xi and eta; not below the geometry's."},
    {"discretisation.elements", Kind::integers, required, "", "", "[1, 100000]", 2,
     "Parts into which each knot span of the geometry is cut, along xi and eta."},

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
    {"supports[].edge", Kind::word, required, "", "", edges, 0,
     "Edge that is held."},
    {"supports[].fix", Kind::words, required, "", "", "x y", 0,
     "Displacement components that are zero on the edge (exactly: the basis interpolates there)."},

    {"loads", Kind::mapList, defaulted, "[]", "", "", 0,
     "Loads of the structure's own; each item has either edge and traction, or gravity."},
    {"loads[].edge", Kind::word, optional, "", "", edges, 0,
     "Edge that is loaded."},
    {"loads[].traction", Kind::formulas, optional, "", "Pa", "", 2,
     "Force per reference area along x and y; it keeps its direction as the body deforms."},
    {"loads[].gravity", Kind::formulas, optional, "", "m/s^2", "", 2,
     "Acceleration along x and y that acts on the mass."},

    {"time", Kind::map, defaulted, "{}", "", "", 0,
     "Time integration."},
    {"time.scheme", Kind::word, defaulted, "generalisedAlpha", "", "generalisedAlpha newmark static", 0,
     "generalisedAlpha: Chung & Hulbert 1993, order 2, dissipates high frequencies only. newmark: by beta and gamma. static: no inertia, a load step each time step."},
    {"time.spectralRadius", Kind::number, optional, "", "", "[0, 1]", 0,
     "generalisedAlpha: amplification of infinitely high frequencies; 1 keeps all energy, 0 annihilates them in one step. 0.8 if not given."},
    {"time.beta", Kind::number, optional, "", "", "(0, 0.5]", 0,
     "newmark: 0.25 if not given (with gamma 0.5: trapezoidal rule)."},
    {"time.gamma", Kind::number, optional, "", "", "[0.5, 1]", 0,
     "newmark: 0.5 if not given; larger values dissipate and reduce the order to 1."},
    {"time.step", Kind::number, optional, "", "s", "(0, inf)", 0,
     "Time step of a run alone; a coupled run takes the fluid's."},
    {"time.end", Kind::number, optional, "", "s", "(0, inf)", 0,
     "End of a run alone, which begins at 0; a coupled run takes the fluid's."},

    {"newton", Kind::map, defaulted, "{}", "", "", 0,
     "Equilibrium iterations with nonlinear strains."},
    {"newton.tolerance", Kind::number, defaulted, "1e-8", "", "(0, 1)", 0,
     "Out-of-balance force over the largest of the forces in balance (internal, inertia, external)."},
    {"newton.maximumIterations", Kind::integer, defaulted, "25", "", "[1, 1000]", 0,
     "Iterations after which the time step has failed."},
    {"newton.lineSearch", Kind::yesNo, defaulted, "yes", "", "", 0,
     "Shorten an update that does not reduce the residual along its own direction, or inverts the body."},

    {"coupling", Kind::map, optional, "", "", "", 0,
     "Coupling to a fluid; not looked at in a run alone."},
    {"coupling.interface", Kind::words, required, "", "", edges, 0,
     "Wet edges; where two of them meet, a point belongs to the one named first."},
    {"coupling.mapping", Kind::map, defaulted, "{}", "", "", 0,
     "Transfer between the fluid's points and faces and the structure."},
    {"coupling.mapping.type", Kind::word, defaulted, "nearestElement", "", "nearestElement", 0,
     "nearestElement: displacement of the spline at the closest point; forces by the transpose, at face centres."},
    {"coupling.mapping.gapLimit", Kind::number, defaulted, "0.01", "", "(0, inf)", 0,
     "Largest distance of a fluid point from the structure, relative to the interface's extent; beyond it the run does not start."},
    {"coupling.predictor", Kind::word, defaulted, "linear", "", "constant linear quadratic", 0,
     "Polynomial through accepted interface displacements that starts a time step."},
    {"coupling.acceleration", Kind::map, defaulted, "{}", "", "", 0,
     "How the next interface displacement follows from the last exchanges."},
    {"coupling.acceleration.type", Kind::word, defaulted, "iqnIls", "", "explicit constant aitken iqnIls mvqn", 0,
     "explicit: one exchange a time step, nothing iterated. constant: constant relaxation. aitken: dynamic relaxation. iqnIls: interface quasi-Newton by least squares. mvqn: multi-vector quasi-Newton, whose Jacobian is carried over time steps."},
    {"coupling.acceleration.relaxation", Kind::number, optional, "", "", "(0, 2]", 0,
     withDefault("constant: share of the residual added", coupled.relaxation)},
    {"coupling.acceleration.initialRelaxation", Kind::number, optional, "", "", "(0, 2]", 0,
     withDefault("aitken, iqnIls, mvqn: share of the residual in a move about which nothing is known yet", coupled.initialRelaxation)},
    {"coupling.acceleration.smallestRelaxation", Kind::number, optional, "", "", "(0, 2]", 0,
     withDefault("aitken: lower bound", coupled.smallestRelaxation)},
    {"coupling.acceleration.largestRelaxation", Kind::number, optional, "", "", "(0, inf)", 0,
     withDefault("aitken: upper bound", coupled.largestRelaxation)},
    {"coupling.acceleration.reusedTimeSteps", Kind::integer, optional, "", "", "[0, inf)", 0,
     withDefault("iqnIls: earlier time steps whose differences are used", coupled.reusedTimeSteps)},
    {"coupling.acceleration.largestColumns", Kind::integer, optional, "", "", "[1, inf)", 0,
     withDefault("iqnIls: differences kept at most, the newest ones", coupled.largestColumns)},
    {"coupling.acceleration.largestRank", Kind::integer, optional, "", "", "[1, inf)", 0,
     withDefault("mvqn: rank of the Jacobian at which it restarts with the half of it, by singular values", coupled.largestRank)},
    {"coupling.acceleration.rankLimit", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("mvqn: at a restart singular values below this share of the largest are dropped", coupled.rankLimit)},
    {"coupling.acceleration.filter", Kind::word, optional, "", "", "qr1 qr2", 0,
     "iqnIls, mvqn: which differences count as dependent. qr1: by the diagonal of R against its norm; qr2: by what is new in a difference against its length; qr2 if not given."},
    {"coupling.acceleration.filterLimit", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("iqnIls, mvqn: limit of the filter", coupled.filterLimit)},
    {"coupling.acceleration.signalToNoise", Kind::number, optional, "", "", "[0, inf)", 0,
     withDefault("iqnIls, mvqn: a difference is used if it exceeds, relative to the displacement, this many residuals of the fluid; 0: always", coupled.signalToNoise)},
    {"coupling.acceleration.largestStep", Kind::number, optional, "", "", "[0, inf)", 0,
     withDefault("iqnIls, mvqn: a move is at most this many residuals long; 0: any", coupled.largestStep)},
    {"coupling.acceleration.keepFraction", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("iqnIls, mvqn: after a time step its differences below this share of its largest are dropped; 0: none", coupled.keepFraction)},
    {"coupling.convergence", Kind::map, defaulted, "{}", "", "", 0,
     "Criteria beside the fluid's tolerance, which is the relative one for the displacement."},
    {"coupling.convergence.absoluteDisplacement", Kind::number, defaulted, "0", "m", "[0, inf)", 0,
     "A root mean square difference of displacement below this is enough in any case."},
    {"coupling.convergence.relativeForce", Kind::number, defaulted, "0", "", "[0, 1)", 0,
     "Change of force between exchanges, relative; both force entries 0: not looked at."},
    {"coupling.convergence.absoluteForce", Kind::number, defaulted, "0", "N (2D: N/m)", "[0, inf)", 0,
     "A root mean square change of force below this is enough in any case."},

    {"output", Kind::map, defaulted, "{}", "", "", 0,
     "Results."},
    {"output.directory", Kind::text, defaulted, "results", "", "", 0,
     "Where the .pvd and .vtu files go, relative to the case file."},
    {"output.interval", Kind::integer, defaulted, "10", "time steps", "[0, inf)", 0,
     "Run alone: time steps between two results; 0: none. A coupled run writes when the fluid writes."},
    {"output.fields", Kind::words, defaulted, "[displacement, velocity, stress]", "", "displacement velocity acceleration stress vonMisesStress", 0,
     "Fields of the .vtu files; stress is Cauchy's."},
    {"output.cells", Kind::word, defaulted, "quads", "", "quads bezier", 0,
     "quads: each element cut into subdivision x subdivision flat cells, for any reader. bezier: one exact (rational) Bezier cell an element, for ParaView 5.8 or later."},
    {"output.subdivision", Kind::integer, defaulted, "4", "", "[1, 100]", 0,
     "Cells along each side of an element, with quads."},
    {"output.watchPoints", Kind::mapList, defaulted, "[]", "", "", 0,
     "Points whose displacement is logged and tabulated each time step; the first one is shown in the log."},
    {"output.watchPoints[].name", Kind::text, required, "", "", "", 0,
     "Name of its columns."},
    {"output.watchPoints[].at", Kind::numbers, required, "", "m", "", 2,
     "Position [x, y] in the reference configuration."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
