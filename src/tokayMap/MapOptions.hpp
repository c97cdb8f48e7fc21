// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/makeMapping.hpp"

namespace tokay::tool {

/// Options of the command line.
struct MapOptions {
    std::string from, to;
    /// Values to map, one of the three: a field of the file, a file of values, or a
    /// formula in x, y, z.
    std::string field, valuesFile, testFunction;
    /// Maps forces, by the transpose of the mapping back.
    bool conservative = false;
    OperatorOptions mapping;
    /// Location of the values of `from`; empty: where the field is.
    std::optional<mapper::ValuesAt> fromAt;
    mapper::ValuesAt toAt = mapper::ValuesAt::vertices;
    /// Units of the files' lengths [m]; empty: metres, and sizes that differ a hundredfold
    /// are refused.
    std::optional<double> scaleFrom, scaleTo;
    int degree = 1;
    int nDivisions = 1;
    /// Edges of spline models, by name; empty: the surfaces.
    std::vector<std::string> edgesFrom, edgesTo;
    /// Names of the files to write; empty: none.
    std::string output, report;

    SideOptions sideFrom(mapper::ValuesAt at) const {
        return {scaleFrom.value_or(1), at, degree, nDivisions, edgesFrom};
    }
    SideOptions sideTo() const { return {scaleTo.value_or(1), toAt, degree, nDivisions, edgesTo}; }
};

} // namespace tokay::tool
