// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tokay::structure {

/// Points and weights on [0, 1].
struct GaussRule {
    std::vector<double> points;
    std::vector<double> weights;
};

/// Gauss-Legendre rule, exact for polynomials of degree 2 nPoints - 1.
GaussRule gaussRule(int nPoints);

} // namespace tokay::structure
