// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <string>
#include <vector>

namespace tokay::mapper {

using geometry::Point;
using geometry::Points;

/// Where a mesh carries its values: a finite element mesh at its vertices, a
/// finite volume mesh on its faces.
enum class ValuesAt { vertices, faces };

/// Basis functions at a place of a discretisation: a value there is the sum of weights times
/// values.
struct Functions {
    /// Indices of the values, and the weight of each.
    std::vector<int> values;
    Eigen::VectorXd weights;
};

/// Functions of a triangle of a mesh: at barycentric coordinates b the weights are weights * b.
struct CornerFunctions {
    std::vector<int> values;
    /// At the three corners, values.size() x 3.
    Eigen::Matrix<double, Eigen::Dynamic, 3> weights;
};

/// The closest place to a point, and the functions there.
struct Location : Functions {
    /// Distance from the point to its projection [m].
    double gap;
    bool converged;
    /// True if another place is as near.
    bool ambiguous;
};

/// Discretisation of one side of an interface: a field on it is given by nValues() numbers
/// (values of vertices, faces or control points).
class Discretisation {
  public:
    virtual ~Discretisation() = default;

    /// Name of the mapping from it by locate(), for reports.
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
