// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/RowSparseMatrix.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/SurfaceMesh.hpp"

namespace tokay::mapper {

/// Integrals over the whole elements that trimming cuts, for the values that the interface
/// leaves open (GradientExtension).
struct GradientTerm {
    RowSparseMatrix energy; ///< of slopes of the destination's functions, nTo x nTo
    RowSparseMatrix slopes; ///< of these and of the source's at the closest place, nTo x nFrom
};

/// Edges of trimmed patches: slopes along the surface, normal to the edge. A source knows
/// them if it is the edge of a patch, too.
GradientTerm gradientTerm(const CurveInterface& from, const CurveInterface& to);

/// Trimmed patches: slopes in all directions of the surface, in cut elements.
GradientTerm gradientTerm(const SurfaceInterface& from, const SurfaceInterface& to);
/// A mesh knows no slopes: they count as 0.
GradientTerm gradientTerm(const SurfaceMesh& from, const SurfaceInterface& to);

} // namespace tokay::mapper
