// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/Coupling.hpp"

#include "common/couplingPresets.hpp"
#include "coupling/couplingMethods.hpp"
#include "igaStructure/caseFile/describeSchema.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

const Choices<std::string>& faceNames() {
    static const Choices<std::string> faces = {{"left", "left"},     {"right", "right"},
                                               {"bottom", "bottom"}, {"top", "top"},
                                               {"back", "back"},     {"front", "front"}};
    return faces;
}

// Those for every body; a thin one has offset besides.
Choices<TransferMethod> surfaceMethods() {
    return {
        {"nearestElement", TransferMethod::nearestElement,
         "displacement of the spline at the closest point."},
        {"nearestNeighbour", TransferMethod::nearestNeighbour,
         "displacement of the spline at its nearest Greville point: constant between them."},
        {"rbf", TransferMethod::rbf,
         "interpolation between the spline's Greville points by thin plate functions and linear "
         "polynomials."},
        {"mortar", TransferMethod::mortar,
         "L2 projection onto the functions of the fluid's faces, integrated on the intersection "
         "of faces and knot spans; points on the rim of the interface as by nearestElement."},
        {"dualMortar", TransferMethod::dualMortar,
         "the same, tested with the dual basis: no system is solved."}};
}

const Choices<TransferMethod>& methodChoices(WetParts parts) {
    static const Choices<TransferMethod> ofOthers = surfaceMethods();
    static const Choices<TransferMethod> ofThinBodies = [] {
        Choices<TransferMethod> choices = surfaceMethods();
        choices.insert(choices.begin(),
                       {"offset", TransferMethod::offset,
                        "points of the fluid move with the section in which they lie. The other "
                        "types leave out the distance from the axis or middle surface."});
        return choices;
    }();
    return isThin(parts) ? ofThinBodies : ofOthers;
}

const Choices<LoadTransfer>& loadChoices() {
    static const Choices<LoadTransfer> choices = {
        {"integrated", LoadTransfer::integrated,
         "traction of a face times the spline's functions over its area, by knot spans: right at "
         "any ratio of the sizes; power agrees to the order of the faces."},
        {"transposed", LoadTransfer::transposed,
         "forces at the points of faces, by the transpose of the displacements' mapping: power "
         "agrees to rounding. But for mortar these are point loads, wrong where a face is larger "
         "than a knot span."}};
    return choices;
}

SchemaOf<Coupling> presetSchema() {
    return {
        {"preset", &Coupling::preset, presetChoices(),
         "Named set of defaults: accuracy against cost. Entries that are given win. The fluid's "
         "function object has a preset of its own.",
         otherwise("none")}};
}

SchemaOf<Coupling> mappingSchema(WetParts parts) {
    return {{"type", &Coupling::method, methodChoices(parts), "Mapping of displacements."},
            {"loads", &Coupling::loads, loadChoices(), "Mapping of forces."},
            {"gapLimit", &Coupling::gapLimit, "(0, inf)", "",
             std::string("Maximum distance of a point of the fluid from the ") +
                 (isThin(parts) ? "axis or middle surface" : "structure") +
                 ", relative to the extent of the interface; beyond it the run does not start."}};
}

/// Entries for two structures that are coupled along edges.
SchemaOf<Coupling> pairSchema() {
    static const Choices<CouplingSide> sides = {
        {"neumann", CouplingSide::neumann, "takes forces and gives displacements."},
        {"dirichlet", CouplingSide::dirichlet, "takes displacements and gives forces."}};
    return {
        {"side", &Coupling::side, sides,
         "Coupled to another structure along edges (igaStructure couple): what this one does. "
         "Beside a fluid: neumann."},
        {"tolerance", &Coupling::tolerance, "(0, 1]", "",
         "side dirichlet: relative residual of the displacement that ends a time step's coupling "
         "iterations.",
         otherwise(fmt::format("`{:g}`", Coupling::defaultTolerance))},
        {"maxIterations", &Coupling::maxIterations, "[1, inf)", "",
         "side dirichlet: coupling iterations in a time step; if they do not converge the run "
         "fails.",
         otherwise(fmt::format("`{}`", Coupling::defaultMaxIterations))}};
}

} // namespace

const Choices<std::string>& presetChoices() {
    static const Choices<std::string> choices = [] {
        Choices<std::string> all;
        for (const CouplingPreset& preset : couplingPresets()) {
            all.emplace_back(preset.name, preset.name,
                             fmt::format("{} Sets {}.", preset.meaning, listed(preset.caseFile)));
        }
        return all;
    }();
    return choices;
}

void requireValid(const Coupling& coupling) {
    for (const auto& [name, isGiven] :
         {std::pair("tolerance", coupling.tolerance.has_value()),
          std::pair("maxIterations", coupling.maxIterations.has_value())}) {
        if (isGiven && coupling.side == CouplingSide::neumann) {
            throw coupling.error(name, "goes with side: dirichlet, which leads the coupled run; "
                                       "beside a fluid, residualControl has the tolerance");
        }
    }
}

SchemaOf<Coupling> couplingSchema(WetParts parts) {
    static const Choices<UnreachedParts> unreached = {
        {"refuse", UnreachedParts::refuse, "the run does not start."},
        {"accept", UnreachedParts::accept, "they are named in the log."}};
    const SchemaOf<Coupling> wetEdges = {
        {"interface", &Coupling::interface,
         "Wet edges (left, right, bottom, top); a point at which two of them meet belongs to the "
         "one named first. cadJson: edges, by name, that meet another structure (igaStructure "
         "couple).",
         required}};
    const SchemaOf<Coupling> wetFaces = {
        {"interface", &Coupling::interface, faceNames(),
         "Wet faces; a point at which two of them meet belongs to the one named first.", required}};
    const SchemaOf<Coupling> unreachedParts = {
        {"unreached", &Coupling::unreached, unreached,
         "Wet parts before which no face of the fluid lies, so that no force acts there."}};
    const SchemaOf<Coupling> edges = {
        {"interface", &Coupling::interface,
         "Edges of the model, by name, that meet another structure (igaStructure couple); a fluid "
         "wets the whole body.",
         otherwise("`[]`")}};
    const SchemaOf<Coupling> others = {
        {"mapping", mappingSchema(parts), "Transfer between fluid and structure."}};
    const bool hasEdges = parts == WetParts::edges || parts == WetParts::surface;
    return SchemaOf<Coupling>()
        .with(presetSchema())
        .with(parts == WetParts::edges     ? wetEdges
              : parts == WetParts::faces   ? wetFaces
              : parts == WetParts::surface ? edges
                                           : SchemaOf<Coupling>())
        .with(isThin(parts) ? SchemaOf<Coupling>() : unreachedParts)
        .with(others)
        .with(hasEdges ? pairSchema() : SchemaOf<Coupling>())
        .with(&Coupling::options, coupling::couplingSchema());
}

namespace {

std::string describeMethod(const Coupling& coupling) {
    coupling::CouplingOptions options = coupling.options;
    const std::string substeps =
        coupling.substeps == 1 ? ""
                               : fmt::format("\n  {} structural time steps per time step of the "
                                             "fluid, which excludes the acceleration block",
                                             coupling.substeps);
    return fmt::format("{}  {}{}\n", coupling.presetReport,
                       describeOptions(coupling::couplingSchema(), &options), substeps);
}

} // namespace

std::string describeCoupling(const Coupling& coupling) {
    return fmt::format("coupling: interface {}, displacements {}, loads {}, gap limit {:g}\n",
                       coupling.interface.empty()
                           ? "the whole body"
                           : fmt::format("{}", fmt::join(coupling.interface, " ")),
                       nameOf(coupling.method, methodChoices(WetParts::all)),
                       nameOf(coupling.loads, loadChoices()), coupling.gapLimit) +
           describeMethod(coupling);
}

std::string describeEdgeCoupling(const Coupling& coupling) {
    return fmt::format("coupling: edges {}, gap limit {:g}\n", fmt::join(coupling.interface, " "),
                       coupling.gapLimit) +
           describeMethod(coupling);
}

} // namespace tokay::structure
