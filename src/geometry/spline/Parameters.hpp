// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::geometry {

/// Place (xi, eta) in the parameter space of a surface.
using Parameters = Eigen::Vector2d;

/// Rectangle in parameter space.
struct ParameterBox {
    Parameters lower, upper;

    Parameters size() const { return upper - lower; }
    Parameters centre() const { return 0.5 * (lower + upper); }
    double area() const { return size().prod(); }
    bool overlaps(const ParameterBox& other) const {
        return (lower.array() <= other.upper.array()).all() &&
               (other.lower.array() <= upper.array()).all();
    }
};

} // namespace tokay::geometry
