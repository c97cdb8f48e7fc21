// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// How the points of an interface are numbered on other ranks or in another
/// order: for each point now the number that it had.
/// @param before, now  nPoints x 3, in the reference configuration [m]
/// @return             none unless each point is found again, to 1e-6 of the
///                     interface's extent
std::optional<std::vector<int>> interfaceRenumbering(const geometry::Points& before,
                                                     const geometry::Points& now);

/// The same for the components of vectors with `dimension` rows a point.
std::vector<int> componentNumbers(const std::vector<int>& points, int dimension);

} // namespace tokay::structure
