// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Formula.hpp"
#include "igaStructure/kinematics/beam/LineEnd.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// A force that keeps its direction, and in the plane a moment (counter-clockwise),
/// on an end of a line, for its whole width.
struct EndLoad {
    LineEnd end;
    std::optional<std::vector<Formula>> force; ///< x, y and in space z [N]
    std::optional<Formula> moment;             ///< [N m]
};

/// Vectors have the components x, y and in space z.
struct LineLoads {
    std::vector<EndLoad> ends;
    /// Per reference area; they keep their direction [Pa].
    std::vector<std::vector<Formula>> tractions;
    std::vector<std::vector<Formula>> gravities; ///< [m/s^2]
    std::vector<Formula> pressures; ///< in the plane, on the left side, follow the motion [Pa]
};

} // namespace tokay::structure
