// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/gaussLegendre.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace tokay::geometry;

TEST(GaussLegendre, is_exact_for_polynomials_up_to_degree2n_minus1) {
    for (int n = 1; n <= 12; ++n) {
        const QuadratureRule& rule = gaussLegendre(n);
        for (int degree = 0; degree < 2 * n; ++degree) {
            double sum = 0;
            for (int k = 0; k < n; ++k) {
                sum += rule.weights[k] * std::pow(rule.points[k], degree);
            }
            EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14);
        }
    }
}
