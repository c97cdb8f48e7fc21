// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/kinematics/Body.hpp"

namespace tokay::structure {

/// The body that a case describes.
/// @throws InputError with the case file's name
std::unique_ptr<Body> makeBody(const Case& structureCase);

} // namespace tokay::structure
