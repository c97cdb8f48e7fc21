// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/MapOptions.hpp"
#include "tokayMap/Side.hpp"

namespace tokay::tool {

/// Side that is mapped from, and the values on it.
struct Source {
    std::unique_ptr<Side> side;
    Eigen::MatrixXd values;
    /// Name of the field.
    std::string name;
};

/// @throws InputError if a file, the field or the formula is not as it should be
Source readSource(const MapOptions& options);

/// @throws InputError if the formula cannot be read
ScalarFunction testFunctionOf(const MapOptions& options);

} // namespace tokay::tool
