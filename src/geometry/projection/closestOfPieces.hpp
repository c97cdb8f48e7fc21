// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/ClosestCandidate.hpp"
#include "geometry/projection/CurveProjector.hpp"
#include "geometry/projection/closestParameter.hpp"

namespace tokay::geometry {

/// The closest place on a curve that is cut into pieces, nearest piece first.
/// @param tree       over boxes that hold the pieces
/// @param size       length to which distances compare as equal [m]
/// @param closestIn  number of a piece -> ClosestParameter<1> in it
template <class ClosestIn>
CurveProjection closestOfPieces(const BoxTree& tree, const Point& point, double size,
                                const ClosestIn& closestIn) {
    ClosestCandidate candidate(size);
    CurveProjection best{};
    tree.visitNearest(point, [&](int piece) {
        const ClosestParameter<1> found = closestIn(piece);
        if (candidate.offer(found.offset)) {
            best.xi = found.parameter[0];
            best.converged = found.converged;
        }
        return candidate.squaredLimit();
    });
    best.distance = candidate.distance();
    best.ambiguous = candidate.isAmbiguous();
    return best;
}

} // namespace tokay::geometry
