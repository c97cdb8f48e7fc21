// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/gaussLegendre.hpp"

#include <cassert>
#include <cmath>
#include <map>
#include <mutex>

namespace tokay::geometry {

namespace {

/// Value and derivative of the Legendre polynomial of degree n.
std::pair<double, double> legendre(int n, double x) {
    double value = 1, previous = 0;
    for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
    }
    return {value, n * (x * value - previous) / (x * x - 1)};
}

/// Newton from Chebyshev's guess, which lies in each root's basin.
QuadratureRule computed(int n) {
    QuadratureRule rule;
    for (int i = n - 1; i >= 0; --i) {
        double x = std::cos(std::acos(-1.0) * (i + 0.75) / (n + 0.5));
        for (int iteration = 0; iteration < 10; ++iteration) {
            const auto [value, slope] = legendre(n, x);
            x -= value / slope;
        }
        const double slope = legendre(n, x).second;
        rule.points.push_back((1 + x) / 2);
        rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

} // namespace

const QuadratureRule& gaussLegendre(int n) {
    assert(n >= 1);
    static std::map<int, QuadratureRule> rules;
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    auto found = rules.find(n);
    if (found == rules.end()) {
        found = rules.emplace(n, computed(n)).first;
    }
    return found->second;
}

} // namespace tokay::geometry
