// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Mapping.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/rbf/RbfMapping.hpp"
#include "tokayMap/Side.hpp"

namespace tokay::tool {

enum class Operator { nearestNeighbour, nearestElement, rbf, mortar };

struct OperatorOptions {
    Operator kind = Operator::nearestElement;
    /// Relative to the size of the source; empty: the operator's default.
    std::optional<double> gapLimit;
    /// Points beyond the limit are counted, not refused.
    bool allowGaps = false;
    mapper::RbfOptions rbf;
    mapper::MortarOptions mortar;
};

/// True if the mapping gives values of the destination's discretisation; if
/// not, they are its samples.
bool givesValues(Operator kind);

/// Makes the consistent mapping between two sides.
/// @throws InputError, SolverError as the mappings do; InputError too for pairs
/// for which the operator is not defined
std::unique_ptr<mapper::Mapping> makeMapping(const Side& from, const Side& to,
                                             const OperatorOptions& options);

} // namespace tokay::tool
