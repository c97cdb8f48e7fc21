// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <string>

namespace tokay::structure {

/// Values of a field at the points of a result file, a column a point.
struct ResultField {
    std::string name;
    Eigen::MatrixXd values;
};

} // namespace tokay::structure
