// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <functional>

namespace tokay::structure {

/// A vector or number given by place in the reference configuration and time.
template <class Value>
struct Field {
    std::function<Value(const geometry::Point&, double)> value;
    bool dependsOnTime = false;
    bool dependsOnPlace = false;

    static Field constant(const Value& value) {
        return {[value](const geometry::Point&, double) { return value; }};
    }
};
using VectorField = Field<Eigen::Vector3d>;
using ScalarField = Field<double>;

} // namespace tokay::structure
