// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "coupling/step/CouplingOptions.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// How displacements of the structure become those of the fluid's points.
enum class TransferMethod {
    nearestNeighbour, ///< the spline's value at its nearest sample
    nearestElement,   ///< the spline's value at the closest point
    rbf,              ///< interpolation between samples of the spline
    mortar,           ///< L2 projection onto the fluid's faces
    dualMortar,       ///< the same, tested with the dual basis
    offset            ///< motion of the section of a thin body in which a point lies
};

/// How forces on the fluid's faces become loads on the structure.
enum class LoadTransfer {
    integrated, ///< traction times the spline's functions over the area of the face
    transposed  ///< forces at the face's points by the transpose of the displacements' mapping
};

/// What to do about wet parts that no face of the fluid reaches.
enum class UnreachedParts { refuse, accept };

/// What a structure takes at its coupled edges.
enum class CouplingSide {
    neumann,  ///< forces, and gives displacements, as beside a fluid
    dirichlet ///< displacements, and gives forces; beside another structure
};

/// Entries of `coupling` in the case file.
struct Coupling : Located {
    static constexpr double defaultTolerance = 1e-8;
    static constexpr int defaultMaxIterations = 50;

    std::optional<std::string> preset; ///< of couplingPresets()
    std::string presetReport;          ///< what it has set, for the log
    CouplingSide side = CouplingSide::neumann;
    std::optional<double> tolerance;  ///< of the dirichlet side
    std::optional<int> maxIterations; ///< of the dirichlet side
    TransferMethod method = TransferMethod::nearestElement;
    LoadTransfer loads = LoadTransfer::integrated;
    std::vector<std::string> interface; ///< names of the wet parts; empty: all of a thin body
    UnreachedParts unreached = UnreachedParts::refuse; ///< with names in interface
    double gapLimit = 0.01;                            ///< relative to the interface's extent
    int substeps = 1; ///< of the structure in a time step of the fluid
    coupling::CouplingOptions options;
};

/// What of a body can be wet.
enum class WetParts {
    edges,
    faces,
    all,    ///< of a line
    surface ///< all of a surface, whose edges may meet another structure
};
constexpr bool isThin(WetParts parts) {
    return parts == WetParts::all || parts == WetParts::surface;
}

/// Entries of `coupling` of a body with given wet parts.
SchemaOf<Coupling> couplingSchema(WetParts parts);

template <WetParts parts>
struct CouplingEntries : Coupling {
    CouplingEntries() {
        if (isThin(parts)) {
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

/// Presets as choices of `coupling.preset`.
const Choices<std::string>& presetChoices();

/// @throws InputError for entries that do not fit each other
void requireValid(const Coupling& coupling);

/// Options in effect, for the log: several lines.
std::string describeCoupling(const Coupling& coupling);
/// The same of those that count beside another structure.
std::string describeEdgeCoupling(const Coupling& coupling);

} // namespace tokay::structure
