// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "igaStructure/timeIntegration/TimeScheme.hpp"

#include <optional>
#include <variant>

namespace tokay::structure {

/// Explicit time integration, with the lumped mass.
struct CentralDifferences {};

/// Equilibrium path of a static structure, through limit points.
struct EquilibriumPath {
    int maxSteps = 1000;
    double maxGrowth = 4; ///< longest arc over the first one
};

/// How a structure is advanced in time.
using TimeIntegration = std::variant<TimeScheme, CentralDifferences, EquilibriumPath>;

/// Entries of `time` in the case file.
struct TimeOptions : Located {
    /// Makes the chosen scheme of its options.
    using Scheme = TimeIntegration (*)(const TimeOptions&);
    Scheme scheme = generalisedAlpha;
    double spectralRadius = 0.8;
    double beta = 0.25;
    double gamma = 0.5;
    std::optional<double> step;
    std::optional<double> end;
    std::optional<double> minDeltaT;
    int substeps = 1;
    int maxSteps = EquilibriumPath().maxSteps;
    double maxGrowth = EquilibriumPath().maxGrowth;

    static const SchemaOf<TimeOptions>& schema();

    /// @throws InputError if step and end do not fit each other
    void requireValid() const;

    static TimeIntegration generalisedAlpha(const TimeOptions& options);
    static TimeIntegration newmark(const TimeOptions& options);
    static TimeIntegration quasiStatic(const TimeOptions& options);
    static TimeIntegration arcLength(const TimeOptions& options);
    static TimeIntegration centralDifferences(const TimeOptions& options);
};

} // namespace tokay::structure
