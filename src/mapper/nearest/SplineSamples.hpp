// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"

namespace tokay::mapper {

/// Places on splines that stand for them in mappings between points: those of the
/// Greville parameters, as many as there are control points, without those that
/// trimming leaves out or that coincide with an earlier one.
struct SplineSamples {
    Points points;             ///< nPoints x 3 [m]
    RowSparseMatrix functions; ///< nPoints x nControlPoints
};

SplineSamples splineSamples(const SplineInterface& splines);
SplineSamples splineSamples(const SurfaceInterface& splines);

} // namespace tokay::mapper
