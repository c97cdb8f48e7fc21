#include "igaStructure/body/makeBody.hpp"

#include "common/errors.hpp"
#include "igaStructure/body/PlaneBody.hpp"

namespace tokay::structure {

namespace {

// A kinematics adds its own overload.
std::unique_ptr<Body> make(const PlaneSolidCase& solid) {
    return std::make_unique<PlaneBody>(
        PlaneSolid(solid.surface, solid.material, solid.strains, solid.supports, solid.loads));
}

} // namespace

std::unique_ptr<Body> makeBody(const Case& structureCase) {
    try {
        return std::visit([](const auto& structure) { return make(structure); },
                          structureCase.structure);
    } catch (const InputError& error) {
        throw InputError(structureCase.file + ": " + error.what());
    }
}

} // namespace tokay::structure
