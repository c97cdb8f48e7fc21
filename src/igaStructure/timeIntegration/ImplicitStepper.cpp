// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/ImplicitStepper.hpp"

#include "common/errors.hpp"

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
        } catch (const SolverError&) {
            integrator_.rejectTimeStep();
            step *= 0.5;
            if (step < minStep_) {
                throw;
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

} // namespace tokay::structure
