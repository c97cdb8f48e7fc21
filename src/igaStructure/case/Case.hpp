// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/OutputOptions.hpp"
#include "igaStructure/kinematics/beam/BeamDescription.hpp"
#include "igaStructure/kinematics/plane/PlaneSolidCase.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"
#include "igaStructure/kinematics/solid/SolidDescription.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"
#include "igaStructure/timeIntegration/TimeOptions.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <variant>

namespace tokay::structure {

/// Time steps of a run alone, which begins at 0.
struct TimeSteps {
    double step;      ///< [s]
    double end;       ///< [s]
    double minDeltaT; ///< a failed step is halved down to this; step: never [s]

    /// A remainder shorter than rounding error is no step.
    int count() const { return static_cast<int>(std::ceil(end / step * (1 - 1e-12))); }
};

/// Geometry, model, material, supports and loads of one of the kinematics.
using StructureCase = std::variant<PlaneSolidCase, PlanePatchesCase, BeamDescription,
                                   ShellDescription, SolidDescription>;

/// All that a case file says, checked and with its defaults.
struct Case {
    std::string name;
    std::string file;
    std::string directory; ///< of the case file; results go below it
    StructureCase structure;
    TimeIntegration timeScheme;
    std::optional<TimeSteps> timeSteps;
    NewtonOptions newton;
    OutputOptions output;
    std::optional<Coupling> coupling;
    std::string supportsPlace; ///< file, line and entry: begins messages
    std::string geometryPlace; ///< the same of what gives the body its shape
    std::string digest;        ///< of geometry and discretisation: what the unknowns belong to

    /// The implicit time scheme; null if there is none.
    const TimeScheme* implicitScheme() const { return std::get_if<TimeScheme>(&timeScheme); }

    /// Whether inertia counts.
    bool isDynamic() const {
        return std::holds_alternative<CentralDifferences>(timeScheme) ||
               (implicitScheme() && implicitScheme()->dynamic);
    }
};

} // namespace tokay::structure
