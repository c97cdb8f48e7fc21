// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CouplingOptions.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// How points and faces of the fluid are tied to the structure.
enum class TransferMethod {
    nearestElement, ///< to the closest places of wet edges
    offset          ///< to sections of a thin body, through its thickness
};

/// Entries of `coupling` in the case file.
struct Coupling {
    TransferMethod method = TransferMethod::nearestElement;
    std::vector<std::string> interface; ///< names of the wet parts; empty: all of a thin body
    double gapLimit;                    ///< relative to the interface's extent
    int substeps = 1;                   ///< of the structure in a time step of the fluid
    coupling::CouplingOptions options;
};

} // namespace tokay::structure
