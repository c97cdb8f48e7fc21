// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Formula.hpp"
#include "geometry/spline/NurbsSurface.hpp"

#include <array>
#include <vector>

namespace tokay::structure {

/// Force per reference area on an edge [Pa]; keeps its direction.
struct SideTraction {
    geometry::Edge edge;
    std::array<Formula, 2> traction;
};

/// Acceleration field that acts on the mass [m/s^2].
struct Gravity {
    std::array<Formula, 2> acceleration;
};

struct Loads {
    std::vector<SideTraction> tractions;
    std::vector<Gravity> gravities;
};

} // namespace tokay::structure
