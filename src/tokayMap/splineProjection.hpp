// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceInterface.hpp"

#include <functional>

namespace tokay::tool {

/// The values of control points whose field is closest to a function, in the mean
/// square over the patches inside their loops; of least norm where the patches
/// do not determine them.
Eigen::VectorXd splineProjection(const mapper::SurfaceInterface& splines,
                                 const std::function<double(const geometry::Point&)>& function);

} // namespace tokay::tool
