// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/caseEntryTables.hpp"

namespace tokay::structure {

using namespace casePresence;

// clang-format off
const std::vector<CaseEntry>& solutionEntries() {
    static const std::vector<CaseEntry> entries = {
    // path, kind, presence, default, unit, allowed, count, meaning
    {"time", Kind::map, defaulted, "{}", "", "", 0,
     "Time integration."},
    {"time.scheme", Kind::word, defaulted, "generalisedAlpha", "", "generalisedAlpha newmark static arcLength explicit", 0,
     "generalisedAlpha: Chung & Hulbert 1993, order 2, dissipates high frequencies only. newmark: by beta and gamma. static: no inertia, a load step each time step. arcLength: run alone, static, follows the path of equilibrium through limit points, time being the loads' parameter that may fall again. explicit: run alone, central differences with lumped mass; each time step is taken in as many parts as stability needs."},
    {"time.spectralRadius", Kind::number, optional, "", "", "[0, 1]", 0,
     "generalisedAlpha: amplification of infinitely high frequencies; 1 keeps all energy, 0 annihilates them in one step. 0.8 if not given."},
    {"time.beta", Kind::number, optional, "", "", "(0, 0.5]", 0,
     "newmark: 0.25 if not given (with gamma 0.5: trapezoidal rule)."},
    {"time.gamma", Kind::number, optional, "", "", "[0.5, 1]", 0,
     "newmark: 0.5 if not given; larger values dissipate and reduce the order to 1."},
    {"time.step", Kind::number, optional, "", "s", "(0, inf)", 0,
     "Time step of a run alone; a coupled run takes the fluid's. arcLength: of the first step; the displacement's change in it is the longest step along the path."},
    {"time.substeps", Kind::integer, defaulted, "1", "", "[1, inf)", 0,
     "generalisedAlpha, newmark, coupled: steps that the structure takes in one of the fluid, under the mean of the fluid's forces at its ends; a run alone takes time.step. More than 1: not with the acceleration block; iqnIls is taken if none is given."},
    {"time.smallestStep", Kind::number, optional, "", "s", "(0, inf)", 0,
     "Run alone: a step in which equilibrium is not found is taken in halves, down to this length, and in longer parts again after success; not if not given."},
    {"time.largestSteps", Kind::integer, optional, "", "", "[1, inf)", 0,
     "arcLength: steps after which the run ends if it has not reached time.end; 1000 if not given."},
    {"time.end", Kind::number, optional, "", "s", "(0, inf)", 0,
     "End of a run alone, which begins at 0; a coupled run takes the fluid's."},

    {"newton", Kind::map, defaulted, "{}", "", "", 0,
     "Equilibrium iterations with nonlinear strains."},
    {"newton.tolerance", Kind::number, defaulted, "1e-8", "", "(0, 1)", 0,
     "Out-of-balance force over the largest of the forces in balance (internal, inertia, external)."},
    {"newton.maximumIterations", Kind::integer, defaulted, "25", "", "[1, 1000]", 0,
     "Iterations after which the time step has failed."},
    {"newton.lineSearch", Kind::yesNo, optional, "", "", "", 0,
     "Shorten an update that does not reduce the residual along its own direction, or inverts the body. If not given: no for a shell or beam, whose residual grows before it falls, else yes."},
    {"newton.reuseContraction", Kind::number, optional, "", "", "[0, 1)", 0,
     "A factored tangent is kept, over iterations, solutions and time steps, while an iteration leaves at most this share of the residual (modified Newton), but not beyond a saved or rejected step; 0: a new one in each iteration. If not given: 0.1, with scheme static 0, where each tangent shows whether the structure buckles."},
    };
    return entries;
}
// clang-format on

} // namespace tokay::structure
