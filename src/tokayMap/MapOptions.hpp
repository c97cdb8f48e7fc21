// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/makeMapping.hpp"

namespace tokay::tool {

/// What the command line asks for.
struct MapOptions {
    std::string from, to;
    /// One of the three: a field of the file, a file of values, a formula in x, y, z.
    std::string field, valuesFile, testFunction;
    /// Forces from one side to the other by the transpose of the mapping back.
    bool conservative = false;
    OperatorOptions mapping;
    /// Empty: where the field is.
    std::optional<mapper::ValuesAt> fromAt;
    mapper::ValuesAt toAt = mapper::ValuesAt::vertices;
    /// Empty: the files' lengths are metres, and sizes that differ a hundredfold
    /// are refused.
    std::optional<double> scaleFrom, scaleTo;
    int degree = 1;
    int nDivisions = 1;
    /// Files to write, if named.
    std::string output, report;

    SideOptions sideFrom(mapper::ValuesAt at) const {
        return {scaleFrom.value_or(1), at, degree, nDivisions};
    }
    SideOptions sideTo() const { return {scaleTo.value_or(1), toAt, degree, nDivisions}; }
};

} // namespace tokay::tool
