#pragma once

#include "geometry/PlaneBezier.hpp"
#include <optional>

namespace tokay::geometry {

/// A place where two curves come nearer than the tolerance, if there is one.
std::optional<ParameterPoint> contact(const PlaneBezier& a, const PlaneBezier& b, double tolerance);

/// The same for curves of which b starts where a ends: elsewhere than there.
std::optional<ParameterPoint> contactBesideJoint(const PlaneBezier& a, const PlaneBezier& b,
                                                 double tolerance);

} // namespace tokay::geometry
