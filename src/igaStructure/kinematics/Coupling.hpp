// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "coupling/step/CouplingOptions.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// How points and faces of the fluid are tied to the structure.
enum class TransferMethod {
    nearestElement, ///< to the closest points of wet edges
    offset          ///< to sections of a thin body, through its thickness
};

/// What to do about wet parts that no face of the fluid reaches.
enum class UnreachedParts { refuse, accept };

/// Entries of `coupling` in the case file.
struct Coupling : Located {
    TransferMethod method = TransferMethod::nearestElement; ///< of displacements
    std::optional<TransferMethod> loadMethod; ///< none: the transpose of that of displacements
    std::vector<std::string> interface;       ///< names of the wet parts; empty: all of a thin body
    UnreachedParts unreached = UnreachedParts::refuse; ///< with names in interface
    double gapLimit = 0.01;                            ///< relative to the interface's extent
    int substeps = 1; ///< of the structure in a time step of the fluid
    coupling::CouplingOptions options;
};

/// What of a body can be wet.
enum class WetParts { edges, faces, all };

/// Entries of `coupling` of a body with given wet parts.
SchemaOf<Coupling> couplingSchema(WetParts parts);

template <WetParts parts>
struct CouplingEntries : Coupling {
    CouplingEntries() {
        if (parts == WetParts::all) {
            method = TransferMethod::offset;
            gapLimit = 0.1;
        }
    }

    static const SchemaOf<CouplingEntries>& schema() {
        static const SchemaOf<CouplingEntries> schema =
            SchemaOf<CouplingEntries>().with(couplingSchema(parts));
        return schema;
    }
};

/// Options in effect, for the log: several lines.
std::string describeCoupling(const Coupling& coupling);

} // namespace tokay::structure
