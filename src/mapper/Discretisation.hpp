// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <string>
#include <vector>

namespace tokay::mapper {

using geometry::Point;
using geometry::Points;

/// A value at a place of a discretisation is the sum of weights times values.
struct Functions {
    /// Numbers of the values, and the weight of each.
    std::vector<int> values;
    Eigen::VectorXd weights;
};

/// The closest place to a point, and the functions there.
struct Location : Functions {
    /// Distance from the point to its projection [m].
    double gap;
    bool converged;
    /// Another place is as near.
    bool ambiguous;
};

/// One side of an interface: a field on it is given by nValues() numbers
/// (values of vertices, faces or control points).
class Discretisation {
  public:
    virtual ~Discretisation() = default;

    /// What the mapping from it by locate() is called in reports.
    virtual std::string mappingName() const { return "nearest element"; }

    virtual int nValues() const = 0;

    /// nValues x 3, such that the linear field x has these values.
    virtual const Points& coordinates() const = 0;

    /// Largest extent, the length to which tolerances are relative [m].
    virtual double size() const = 0;

    /// Closest place to the point, and its functions there.
    virtual Location locate(const Point& point) const = 0;
};

} // namespace tokay::mapper
