#pragma once

#include <Eigen/Core>

namespace tokay::geometry {

/// A place (xi, eta) in the parameter space of a surface.
using ParameterPoint = Eigen::Vector2d;

/// Rectangle in parameter space.
struct ParameterBox {
    ParameterPoint lower, upper;

    ParameterPoint size() const { return upper - lower; }
    ParameterPoint centre() const { return 0.5 * (lower + upper); }
    double area() const { return size().prod(); }
    bool overlaps(const ParameterBox& other) const {
        return (lower.array() <= other.upper.array()).all() &&
               (other.lower.array() <= upper.array()).all();
    }
};

} // namespace tokay::geometry
