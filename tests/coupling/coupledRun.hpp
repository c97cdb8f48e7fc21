// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CoupledModel.hpp"
#include "coupling/step/CouplingOptions.hpp"

#include <random>

namespace tokay::coupling {

/// How a fluid that does not converge spoils its answers.
struct Imperfection {
    double noise = 0;  ///< white, relative to the force
    double memory = 0; ///< share of the last answer that is kept
};

/// What a run of many steps cost, the first ones left out.
struct RunResult {
    double meanEvaluations = 0; ///< of the fluid, a step
    int largestEvaluations = 0; ///< of the fluid, in a step
    int nFailed = 0;            ///< steps that did not converge
    int nFailedAtStart = 0;     ///< likewise, of those left out
    double largestError = 0;    ///< of x against the monolithic solution
    int evaluationsOfFirstStep = 0;
};

/// Runs 120 steps, of which the first 20 do not count. A step that has not
/// converged after 50 evaluations of the fluid goes on with the monolithic
/// solution.
RunResult coupledRun(CoupledModel& model, const CouplingOptions& options, double tolerance,
                     const Imperfection& imperfection = {});

} // namespace tokay::coupling
