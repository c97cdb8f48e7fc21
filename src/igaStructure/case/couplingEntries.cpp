// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/step/CouplingOptions.hpp"
#include "igaStructure/case/caseEntryTables.hpp"

#include <fmt/format.h>

namespace tokay::structure {

using namespace casePresence;

namespace {

constexpr auto wetFaces = "left right bottom top back front";

const coupling::CouplingOptions coupled;

std::string withDefault(const char* meaning, double value) {
    return fmt::format("{}; {:g} if not given.", meaning, value);
}

} // namespace

// clang-format off
const std::vector<CaseEntry>& couplingEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"coupling", Kind::map, optional, "", "", "", 0,
     "Coupling to a fluid; not looked at in a run alone."},
    {"coupling.interface", Kind::words, optional, "", "", wetFaces, 0,
     "Wet edges of a plane solid, faces of a solid; where two of them meet, a point belongs to the one named first."},
    {"coupling.mapping", Kind::map, defaulted, "{}", "", "", 0,
     "Transfer between the fluid's points and faces and the structure."},
    {"coupling.mapping.type", Kind::word, optional, "", "", "nearestElement offset", 0,
     "Given by the kinematics. nearestElement: displacement of the spline at the closest point; forces by the transpose, a face's in equal parts at its points (plane solids, solids). offset: points move with the section at which they lie, forces by the transpose at the current state (thin bodies)."},
    {"coupling.mapping.gapLimit", Kind::number, optional, "", "", "(0, inf)", 0,
     "Largest distance of a fluid point from the structure, relative to the interface's extent; beyond it the run does not start. 0.01 if not given; 0.1 from the axis or middle surface of a thin body."},
    {"coupling.predictor", Kind::word, defaulted, "linear", "", "constant linear quadratic cubic", 0,
     "Polynomial through accepted interface displacements that starts a time step."},
    {"coupling.acceleration", Kind::map, defaulted, "{}", "", "", 0,
     "How the next interface displacement follows from the last exchanges."},
    {"coupling.acceleration.type", Kind::word, defaulted, "block", "", "explicit constant aitken iqnIls mvqn block", 0,
     "explicit: one exchange a time step, nothing iterated. constant: constant relaxation. aitken: dynamic relaxation. iqnIls: interface quasi-Newton by least squares. mvqn: multi-vector quasi-Newton, whose Jacobian is carried over time steps. block: the same for the fluid alone, the structure's own factored tangent taking its part."},
    {"coupling.acceleration.relaxation", Kind::number, optional, "", "", "(0, 2]", 0,
     withDefault("constant: share of the residual added", coupled.relaxation)},
    {"coupling.acceleration.initialRelaxation", Kind::number, optional, "", "", "(0, 2]", 0,
     withDefault("aitken, iqnIls, mvqn, block: share of the residual in a move about which nothing is known yet", coupled.initialRelaxation)},
    {"coupling.acceleration.smallestRelaxation", Kind::number, optional, "", "", "(0, 2]", 0,
     withDefault("aitken: lower bound", coupled.smallestRelaxation)},
    {"coupling.acceleration.largestRelaxation", Kind::number, optional, "", "", "(0, inf)", 0,
     withDefault("aitken: upper bound", coupled.largestRelaxation)},
    {"coupling.acceleration.reusedTimeSteps", Kind::integer, optional, "", "", "[0, inf)", 0,
     withDefault("iqnIls: earlier time steps whose differences are used", coupled.reusedTimeSteps)},
    {"coupling.acceleration.largestColumns", Kind::integer, optional, "", "", "[1, inf)", 0,
     withDefault("iqnIls: differences kept at most, the newest ones", coupled.largestColumns)},
    {"coupling.acceleration.largestRank", Kind::integer, optional, "", "", "[1, inf)", 0,
     withDefault("mvqn, block: rank of the Jacobian at which it restarts with the half of it, by singular values", coupled.largestRank)},
    {"coupling.acceleration.rankLimit", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("mvqn, block: at a restart singular values below this share of the largest are dropped", coupled.rankLimit)},
    {"coupling.acceleration.filter", Kind::word, optional, "", "", "qr1 qr2", 0,
     "iqnIls, mvqn: which differences count as dependent. qr1: by the diagonal of R against its norm; qr2: by what is new in a difference against its length; qr2 if not given."},
    {"coupling.acceleration.filterLimit", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("iqnIls, mvqn: limit of the filter; block: noise that a difference has at least, over its length", coupled.filterLimit)},
    {"coupling.acceleration.signalToNoise", Kind::number, optional, "", "", "[0, inf)", 0,
     withDefault("iqnIls, mvqn: a difference is used if it exceeds, relative to the displacement, this many residuals of the fluid; block: these are the noise by which differences are weighed; 0: always", coupled.signalToNoise)},
    {"coupling.acceleration.largestStep", Kind::number, optional, "", "", "[0, inf)", 0,
     withDefault("iqnIls, mvqn: a move is at most this many residuals long; 0: any", coupled.largestStep)},
    {"coupling.acceleration.keepFraction", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("iqnIls, mvqn: after a time step its differences below this share of its largest are dropped; 0: none", coupled.keepFraction)},
    {"coupling.acceleration.fluidMemory", Kind::number, optional, "", "", "[0, 1)", 0,
     withDefault("block: share of its last answer that the fluid keeps from one exchange to the next; the forces are corrected for most of it", coupled.fluidMemory)},
    {"coupling.acceleration.memoryContrast", Kind::number, optional, "", "", "[0, inf)", 0,
     withDefault("block: a difference is used if it exceeds this many times what the last one has left behind by the fluid's memory", coupled.memoryContrast)},
    {"coupling.convergence", Kind::map, defaulted, "{}", "", "", 0,
     "Criteria beside the fluid's tolerance, which is the relative one for the displacement."},
    {"coupling.convergence.absoluteDisplacement", Kind::number, defaulted, "0", "m", "[0, inf)", 0,
     "A root mean square difference of displacement below this is enough in any case."},
    {"coupling.convergence.relativeForce", Kind::number, defaulted, "0", "", "[0, 1)", 0,
     "Change of force between exchanges, relative; both force entries 0: not looked at."},
    {"coupling.convergence.absoluteForce", Kind::number, defaulted, "0", "N (2D: N/m)", "[0, inf)", 0,
     "A root mean square change of force below this is enough in any case."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
