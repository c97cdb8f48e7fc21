// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/Side.hpp"

namespace tokay::tool {

/// Sides that differ a hundredfold in size are hardly one interface: most
/// likely one is in mm, the other in m.
/// @throws InputError that says both sizes and the scale to give
void checkSizes(const Side& from, const Side& to);

} // namespace tokay::tool
