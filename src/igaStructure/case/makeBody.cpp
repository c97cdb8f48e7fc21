// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/makeBody.hpp"

#include "igaStructure/assembly/GeometryError.hpp"
#include "igaStructure/kinematics/beam/BeamBody.hpp"
#include "igaStructure/kinematics/plane/PlaneBody.hpp"
#include "igaStructure/kinematics/plane/PlanePatchesBody.hpp"
#include "igaStructure/kinematics/shell/ShellBody.hpp"
#include "igaStructure/kinematics/solid/SolidBody.hpp"

namespace tokay::structure {

namespace {

// A kinematics adds its own overload.
std::unique_ptr<Body> make(const PlaneSolidCase& solid) {
    return std::make_unique<PlaneBody>(PlaneSolid(solid.surface, solid.material, solid.strains,
                                                  solid.supports, solid.loads, solid.isSlit));
}

std::unique_ptr<Body> make(const PlanePatchesCase& solid) {
    return std::make_unique<PlanePatchesBody>(solid);
}

std::unique_ptr<Body> make(const BeamDescription& beam) {
    return std::make_unique<BeamBody>(
        Beam(beam.curve, beam.section, beam.strains, beam.supports, beam.loads, beam.dimension));
}

std::unique_ptr<Body> make(const ShellDescription& shell) {
    return std::make_unique<ShellBody>(shell);
}

std::unique_ptr<Body> make(const SolidDescription& solid) {
    return std::make_unique<SolidBody>(solid);
}

} // namespace

std::unique_ptr<Body> makeBody(const Case& structureCase) {
    try {
        return std::visit([](const auto& structure) { return make(structure); },
                          structureCase.structure);
    } catch (const GeometryError& error) {
        throw InputError(structureCase.geometryPlace + error.what());
    } catch (const InputError& error) {
        throw InputError(structureCase.file + ": " + error.what());
    }
}

} // namespace tokay::structure
