// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/gaussRule.hpp"

#include <cmath>
#include <limits>

namespace tokay::structure {

namespace {

struct Legendre {
    double value;
    double derivative;
};

Legendre legendre(int degree, double x) {
    double previous = 1;
    double value = x;
    for (int k = 2; k <= degree; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
    }
    return {value, degree * (x * value - previous) / (x * x - 1)};
}

} // namespace

GaussRule gaussRule(int nPoints) {
    GaussRule rule;
    for (int i = 0; i < nPoints; ++i) {
        double x = -std::cos(M_PI * (i + 0.75) / (nPoints + 0.5)); // close to the i-th root
        double step = 1;
        while (std::abs(step) > 4 * std::numeric_limits<double>::epsilon()) {
            const Legendre polynomial = legendre(nPoints, x);
            step = polynomial.value / polynomial.derivative;
            x -= step;
        }
        const double derivative = legendre(nPoints, x).derivative;
        rule.points.push_back(0.5 * (1 + x));
        rule.weights.push_back(1 / ((1 - x * x) * derivative * derivative));
    }
    return rule;
}

} // namespace tokay::structure
