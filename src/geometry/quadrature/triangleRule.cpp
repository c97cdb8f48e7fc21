// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/triangleRule.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"

#include <algorithm>
#include <map>
#include <mutex>

namespace tokay::geometry {

namespace {

/// The three permutations of (1 - 2 a, a, a).
void addOrbit(TriangleRule& rule, double a, double weight) {
    for (int i = 0; i < 3; ++i) {
        Barycentric point = Barycentric::Constant(a);
        point[i] = 1 - 2 * a;
        rule.points.push_back(point);
        rule.weights.push_back(weight);
    }
}

/// The square collapsed onto a corner; the Jacobian costs one degree.
TriangleRule collapsed(int degree) {
    const QuadratureRule& along = gaussLegendre(degree / 2 + 1);
    const QuadratureRule& across = gaussLegendre((degree + 1) / 2 + 1);
    TriangleRule rule;
    for (std::size_t i = 0; i < across.points.size(); ++i) {
        for (std::size_t j = 0; j < along.points.size(); ++j) {
            const double r = across.points[i], s = along.points[j];
            rule.points.emplace_back(1 - r, r * (1 - s), r * s);
            rule.weights.push_back(2 * r * across.weights[i] * along.weights[j]);
        }
    }
    return rule;
}

TriangleRule made(int degree) {
    TriangleRule rule;
    if (degree <= 1) {
        rule.points.push_back(Barycentric::Constant(1.0 / 3));
        rule.weights.push_back(1);
    } else if (degree == 2) {
        addOrbit(rule, 1.0 / 6, 1.0 / 3);
    } else if (degree <= 4) {
        addOrbit(rule, 0.44594849091596488632, 0.22338158967801146570);
        addOrbit(rule, 0.09157621350977074346, 0.10995174365532186764);
    } else {
        rule = collapsed(degree);
    }
    return rule;
}

} // namespace

const TriangleRule& triangleRule(int degree) {
    static std::map<int, TriangleRule> rules;
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    auto found = rules.find(degree);
    if (found == rules.end()) {
        found = rules.emplace(degree, made(degree)).first;
    }
    return found->second;
}

} // namespace tokay::geometry
