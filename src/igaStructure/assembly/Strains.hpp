// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// Small strains and rotations, or Green-Lagrange strains.
enum class Strains { linear, nonlinear };

} // namespace tokay::structure
