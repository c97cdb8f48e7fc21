// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace tokay::structure {

/// Takes one or more lines of text for the log.
using Report = std::function<void(const std::string&)>;

/// Record of an accepted time step, for the log and iterations.dat.
struct StepReport {
    int step = 0;
    int nExchanges = 0;       ///< with the fluid; 0: run alone
    int nIterations = 0;      ///< of Newton's method, all solves of the step
    double firstResidual = 0; ///< of the coupling
    double lastResidual = 0;  ///< coupling: of the final forces; alone: Newton's
    int nColumns = 0;         ///< of the quasi-Newton model
    std::string note;         ///< how the step was taken; empty: as the case file says
};

} // namespace tokay::structure
