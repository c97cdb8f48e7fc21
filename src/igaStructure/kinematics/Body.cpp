// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/Body.hpp"

#include "common/errors.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace tokay::structure {

Body::Body() {
    add({"displacement", "m", 3, true, [this](const MotionState& state, const auto& locations) {
             return displacements(state.displacement, locations);
         }});
    add({"velocity", "m/s", 3, true, [this](const MotionState& state, const auto& locations) {
             return velocities(state, locations);
         }});
    add({"acceleration", "m/s^2", 3, false,
         [this](const MotionState& state, const auto& locations) {
             return accelerations(state, locations);
         }});
}

const BodyField& Body::field(const std::string& name) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const BodyField& field) { return field.name == name; });
    if (found == fields_.end()) {
        std::vector<std::string> known;
        for (const BodyField& field : fields_) {
            known.push_back(fmt::format("{} [{}]", field.name, field.unit));
        }
        throw InputError(fmt::format("output.fields: this structure has no '{}'; it has: {}", name,
                                     fmt::join(known, ", ")));
    }
    return *found;
}

std::vector<BodyField> Body::fields(const std::vector<std::string>& names) const {
    std::vector<BodyField> chosen;
    for (const std::string& name : names) {
        chosen.push_back(field(name));
    }
    if (names.empty()) {
        std::copy_if(fields_.begin(), fields_.end(), std::back_inserter(chosen),
                     [](const BodyField& field) { return field.isDefault; });
    }
    return chosen;
}

std::unique_ptr<const mapper::CurveInterface>
Body::edges(const std::vector<std::string>& /*names*/) const {
    throw InputError("coupling: edges of this kinematics cannot be coupled to another structure; "
                     "those of planeStrain, planeStress and membrane can");
}

std::unique_ptr<InterfaceTransfer> Body::edgeTransfer(const Coupling& coupling,
                                                      const mapper::FaceMesh& points) const {
    const std::unique_ptr<const mapper::CurveInterface> wet = edges(coupling.interface);
    constexpr double wholeDepth = 1; // forces of a structure are in N
    return std::make_unique<InterfaceTransfer>(
        model(), wet->coordinates(),
        std::make_unique<mapper::NearestElementMapping>(*wet, points.vertices,
                                                        mapper::GapLimit{coupling.gapLimit, true}),
        LoadMapping{mapper::loadsAtVertices(points), nullptr}, mapper::FaceSizes(), wholeDepth);
}

std::unique_ptr<InterfaceTransfer> Body::transfer(const Coupling& coupling,
                                                  const mapper::FaceMesh& fluid) const {
    const WetSurface surface = wetSurface(coupling.interface);
    const bool isLinear = model().isLinear();
    return std::visit(
        [&](const auto& wet) {
            return std::make_unique<InterfaceTransfer>(
                model(), wet.coordinates(),
                makeMapping(coupling.method, surface, fluid, {coupling.gapLimit, true}, isLinear),
                makeLoadMapping(coupling, surface, fluid, isLinear), mapper::faceSizes(wet, fluid),
                depth());
        },
        surface);
}

} // namespace tokay::structure
