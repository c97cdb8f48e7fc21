// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/quadrature/Triangle.hpp"

#include <vector>

namespace tokay::geometry {

/// Points in barycentric coordinates and weights with sum 1.
struct TriangleRule {
    std::vector<Barycentric> points;
    std::vector<double> weights;
};

/// A rule of positive weights, exact for polynomials of the degree: symmetric
/// up to degree 4, a collapsed Gauss product above.
/// Source: Dunavant, Int. J. Numer. Meth. Eng. 21, 1985 (degrees 2 and 4)
const TriangleRule& triangleRule(int degree);

} // namespace tokay::geometry
