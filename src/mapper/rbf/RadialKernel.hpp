// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::mapper {

/// Radial basis functions of the distance r, made dimensionless.
/// Source: Wendland, Adv. Comput. Math. 4, 1995 (compact ones, for space)
enum class RadialKernel {
    thinPlate, ///< r^2 log r: smoothest interpolation, a dense matrix
    compactC2, ///< (1 - r)^4 (4 r + 1) for r < 1, sparse
    compactC4, ///< (1 - r)^6 (35 r^2 + 18 r + 3) / 3 for r < 1, sparse
    compactC6  ///< (1 - r)^8 (32 r^3 + 25 r^2 + 8 r + 1) for r < 1, sparse
};

/// @throws InputError that lists the names if there is no such kernel
RadialKernel radialKernelFromName(const std::string& name);
std::string nameOf(RadialKernel kernel);

double valueOf(RadialKernel kernel, double r);

} // namespace tokay::mapper
