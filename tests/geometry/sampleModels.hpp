// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"

namespace tokay::geometry {

/// Two unit squares side by side, the second lifted by a gap, with a hole in the
/// first; edges found by search.
BrepModel twoSquares(double gap = 0);

/// Two half cylinders of radius 1 and height 2 around the z axis.
BrepModel halfCylinders();

/// Largest distance of points of an edge's first curve to its other ones.
double largestGap(const BrepModel& model, const BrepEdge& edge);

} // namespace tokay::geometry
