#pragma once

#include "common/Formula.hpp"
#include "igaStructure/model/LineEnd.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tokay::structure {

/// A force that keeps its direction, and a moment (counter-clockwise), on an
/// end of a line, for its whole width.
struct EndLoad {
    LineEnd end;
    std::optional<std::array<Formula, 2>> force; ///< [N]
    std::optional<Formula> moment;               ///< [N m]
};

struct LineLoads {
    std::vector<EndLoad> ends;
    std::vector<std::array<Formula, 2>> tractions; ///< per reference area, keeps its direction [Pa]
    std::vector<std::array<Formula, 2>> gravities; ///< [m/s^2]
    std::vector<Formula> pressures;                ///< on the left side, follows the motion [Pa]
};

} // namespace tokay::structure
