// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <string>

namespace tokay::tool {

/// Reads a table of numbers, separated by blanks or commas, a row a line; lines
/// that begin with # are passed over.
/// @throws InputError with file and line
Eigen::MatrixXd readValues(const std::string& path);

} // namespace tokay::tool
