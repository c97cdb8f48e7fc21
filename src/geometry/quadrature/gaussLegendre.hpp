// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tokay::geometry {

/// Points in (0, 1) and weights with sum 1.
struct QuadratureRule {
    std::vector<double> points;
    std::vector<double> weights;
};

/// The n-point Gauss-Legendre rule, exact for polynomials of degree 2 n - 1.
/// Computed once for each n, safe to keep.
const QuadratureRule& gaussLegendre(int n);

} // namespace tokay::geometry
