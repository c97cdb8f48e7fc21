// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/ImplicitStepper.hpp"

#include "common/errors.hpp"
#include "igaStructure/timeIntegration/findLimitPoint.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

StepEffort ImplicitStepper::advance(double time, double deltaT) {
    StepEffort effort;
    double step = deltaT;
    while (true) {
        const double remainder = step < deltaT ? time - state().time : deltaT;
        const bool isLast = step >= remainder * (1 - 1e-12);
        integrator_.beginTimeStep(isLast ? time : state().time + step, isLast ? remainder : step);
        try {
            integrator_.solve();
        } catch (const SolverError& error) {
            integrator_.rejectTimeStep();
            step *= 0.5;
            if (step < minStep_) {
                throwFailed(time, error);
            }
            continue;
        }
        integrator_.acceptTimeStep();
        effort.nIterations += integrator_.nIterations();
        effort.residual = integrator_.residuals().empty() ? 0 : integrator_.residuals().back();
        if (isLast) {
            return effort;
        }
        step = std::min(2 * step, 0.5 * deltaT); // whole steps have failed
    }
}

void ImplicitStepper::throwFailed(double time, const SolverError& error) {
    if (isStatic_ && !model_.isLinear()) {
        if (const auto limit = findLimitPoint(model_, newton_, state(), time)) {
            throw SolverError(fmt::format(
                "time {:.6g} s: the load has a limit point at t = {:.4g}, where the structure "
                "snaps: beyond it no equilibrium is near, however small the load step; use "
                "time.scheme arcLength, which follows the path as the load falls",
                time, *limit));
        }
    }
    throw SolverError(error);
}

} // namespace tokay::structure
