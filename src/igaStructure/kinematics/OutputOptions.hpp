// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// A place of the body whose motion is tabulated.
struct WatchPoint {
    std::string name;
    geometry::Point at; ///< reference configuration [m]
};

enum class CellShape { quads, bezier };

/// Entries of `output` in the case file.
struct OutputOptions {
    std::string directory;           ///< of .pvd and .vtu, ready to open
    int interval = 10;               ///< time steps between results, 0: none
    std::vector<std::string> fields; ///< empty: the body's default ones
    CellShape cells = CellShape::quads;
    int subdivision = 4;
    std::vector<WatchPoint> watchPoints;
};

} // namespace tokay::structure
