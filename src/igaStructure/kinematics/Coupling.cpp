// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/Coupling.hpp"

#include "igaStructure/caseFile/describeSchema.hpp"
#include "igaStructure/kinematics/couplingOptionsSchema.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

const Choices<std::string>& partChoices(WetParts parts) {
    static const Choices<std::string> edges = {
        {"left", "left"}, {"right", "right"}, {"bottom", "bottom"}, {"top", "top"}};
    static const Choices<std::string> faces = {{"left", "left"},     {"right", "right"},
                                               {"bottom", "bottom"}, {"top", "top"},
                                               {"back", "back"},     {"front", "front"}};
    return parts == WetParts::edges ? edges : faces;
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
         "of faces and knot spans."},
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
    return parts == WetParts::all ? ofThinBodies : ofOthers;
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

SchemaOf<Coupling> mappingSchema(WetParts parts) {
    return {{"type", &Coupling::method, methodChoices(parts), "Mapping of displacements."},
            {"loads", &Coupling::loads, loadChoices(), "Mapping of forces."},
            {"gapLimit", &Coupling::gapLimit, "(0, inf)", "",
             std::string("Maximum distance of a point of the fluid from the ") +
                 (parts == WetParts::all ? "axis or middle surface" : "structure") +
                 ", relative to the extent of the interface; beyond it the run does not start."}};
}

} // namespace

SchemaOf<Coupling> couplingSchema(WetParts parts) {
    const SchemaOf<Coupling> interface = {
        {"interface", &Coupling::interface, partChoices(parts),
         std::string("Wet ") + (parts == WetParts::edges ? "edges" : "faces") +
             "; a point at which two of them meet belongs to the one named first.",
         required}};
    const SchemaOf<Coupling> others = {
        {"mapping", mappingSchema(parts), "Transfer between fluid and structure."}};
    return (parts == WetParts::all ? SchemaOf<Coupling>() : SchemaOf<Coupling>().with(interface))
        .with(others)
        .with(&Coupling::options, couplingOptionsSchema());
}

std::string describeCoupling(const Coupling& coupling) {
    coupling::CouplingOptions options = coupling.options;
    const std::string substeps =
        coupling.substeps == 1 ? ""
                               : fmt::format("\n  {} structural time steps per time step of the "
                                             "fluid, which excludes the acceleration block",
                                             coupling.substeps);
    return fmt::format(
        "coupling: interface {}, displacements {}, loads {}, gap limit {:g}\n  {}{}\n",
        coupling.interface.empty() ? "the whole body"
                                   : fmt::format("{}", fmt::join(coupling.interface, " ")),
        nameOf(coupling.method, methodChoices(WetParts::all)),
        nameOf(coupling.loads, loadChoices()), coupling.gapLimit,
        describeOptions(couplingOptionsSchema(), &options), substeps);
}

} // namespace tokay::structure
