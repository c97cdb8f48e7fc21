// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/loads/LoadPoints.hpp"

namespace tokay::mapper {

/// Size of faces in knot spans of the structure next to them: lengths of edges over those
/// of spans, in space square roots of areas.
struct FaceSizes {
    double smallest = 0, largest = 0;
    int nOverSpan = 0; ///< faces larger than the span at their centre
    int nFaces = 0;
};

FaceSizes faceSizes(const CurveInterface& splines, const FaceMesh& mesh);
FaceSizes faceSizes(const SurfaceInterface& splines, const FaceMesh& mesh);

} // namespace tokay::mapper
