// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bezier/PlaneBezier.hpp"

#include <optional>

namespace tokay::geometry {

/// A place where two curves come nearer than the tolerance, if there is one.
std::optional<Parameters> contact(const PlaneBezier& a, const PlaneBezier& b, double tolerance);

/// Contact of curves of which b starts where a ends, elsewhere than there.
/// Both of size about 1; what happens within 1e-6 of the joint is not seen.
std::optional<Parameters> contactBesideJoint(const PlaneBezier& a, const PlaneBezier& b,
                                             double tolerance);

} // namespace tokay::geometry
