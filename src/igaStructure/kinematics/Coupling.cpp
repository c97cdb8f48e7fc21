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

const Choices<TransferMethod>& methodChoices(WetParts parts) {
    static const Choices<TransferMethod> ofThinBodies = {
        {"offset", TransferMethod::offset,
         "points of the fluid move with the section in which they lie; forces by the transpose, at "
         "the current state."}};
    static const Choices<TransferMethod> ofOthers = {
        {"nearestElement", TransferMethod::nearestElement,
         "displacement of the spline at the closest point; forces by the transpose, those of a "
         "face in equal parts at its points."}};
    return parts == WetParts::all ? ofThinBodies : ofOthers;
}

SchemaOf<Coupling> mappingSchema(WetParts parts) {
    return {{"type", &Coupling::method, methodChoices(parts), "Mapping."},
            {"gapLimit", &Coupling::gapLimit, "(0, inf)", "",
             std::string("Maximum distance of a point of the fluid from the ") +
                 (parts == WetParts::all ? "axis or middle surface" : "structure") +
                 ", relative to the extent of the interface; beyond it the run does not start."}};
}

} // namespace

SchemaOf<Coupling> couplingSchema(WetParts parts) {
    static const Choices<UnreachedParts> unreached = {
        {"refuse", UnreachedParts::refuse, "the run does not start."},
        {"accept", UnreachedParts::accept, "they are named in the log."}};
    const SchemaOf<Coupling> interface = {
        {"interface", &Coupling::interface, partChoices(parts),
         std::string("Wet ") + (parts == WetParts::edges ? "edges" : "faces") +
             "; a point at which two of them meet belongs to the one named first.",
         required},
        {"unreached", &Coupling::unreached, unreached,
         "Wet parts before which no face of the fluid lies, so that no force acts there."}};
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
        "coupling: interface {}, {}, gap limit {:g}\n  {}{}\n",
        coupling.interface.empty() ? "the whole body"
                                   : fmt::format("{}", fmt::join(coupling.interface, " ")),
        coupling.method == TransferMethod::offset ? "offset" : "nearest element", coupling.gapLimit,
        describeOptions(couplingOptionsSchema(), &options), substeps);
}

} // namespace tokay::structure
