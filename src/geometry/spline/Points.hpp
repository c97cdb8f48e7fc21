// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tokay::geometry {

/// Point in space.
using Point = Eigen::Vector3d;

/// Points in space, one row (x, y, z) each; a 2D scene has z = 0.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Location (xi, eta) in the parameter space of a surface.
using Parameters = Eigen::Vector2d;

/// Quadrature point in the parameter space of a patch.
struct ParameterPoint {
    double xi, eta;
    /// Weight in the parameter area, without the surface's Jacobian.
    double weight;
};

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
