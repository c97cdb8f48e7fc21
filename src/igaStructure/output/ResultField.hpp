#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tokay::structure {

/// Values of a field at the points of a result file, a column a point.
struct ResultField {
    std::string name;
    Eigen::MatrixXd values;
};

/// Parameters (xi, eta) of a point of a patch.
using Parameters = Eigen::Vector2d;

} // namespace tokay::structure
