// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "geometry/spline/Points.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// A point of the body whose motion is tabulated.
struct WatchPoint : Located {
    std::string name;
    Coordinates at; ///< reference configuration [m]

    geometry::Point point() const { return {at.at[0], at.at[1], at.at[2]}; }

    static const SchemaOf<WatchPoint>& schema() {
        static const SchemaOf<WatchPoint> schema = {
            {"name", &WatchPoint::name, "Name of its columns.", required},
            {"at", &WatchPoint::at, "", "m", "Position in the reference configuration.", required}};
        return schema;
    }
};

enum class CellShape { quads, bezier };

/// Entries of `output` in the case file.
struct OutputOptions {
    std::string directory = "results";
    int interval = 10;
    std::vector<std::string> fields; ///< empty: the body's default ones
    CellShape cells = CellShape::quads;
    int subdivision = 4;
    std::vector<WatchPoint> watchPoints;
    std::optional<Coordinates> reactionsAbout;

    static const SchemaOf<OutputOptions>& schema();

    /// Whether a run alone writes results after a step.
    bool writesAt(int step, bool isLast) const {
        return interval > 0 && (isLast || step % interval == 0);
    }

    /// @throws InputError for names of watch points that would break their table
    void requireValid() const;
};

} // namespace tokay::structure
