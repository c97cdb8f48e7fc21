#pragma once

#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/case/Case.hpp"

namespace tokay::structure {

/// The body that a case describes.
/// @throws InputError with the case file's name
std::unique_ptr<Body> makeBody(const Case& structureCase);

} // namespace tokay::structure
