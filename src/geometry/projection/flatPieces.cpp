// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/flatPieces.hpp"

#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/projection/BoxTree.hpp"
#include "geometry/spline/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::geometry {

namespace {

/// Largest distance of n control points, numbered start + step * i, from the
/// places they would have on an evenly parametrised straight line.
double bend(const Points& points, int start, int step, int n) {
    const auto first = points.row(start), last = points.row(start + step * (n - 1));
    double largest = 0;
    for (int i = 1; i < n - 1; ++i) {
        const double t = static_cast<double>(i) / (n - 1);
        largest =
            std::max(largest, (points.row(start + step * i) - (1 - t) * first - t * last).norm());
    }
    return largest;
}

/// Parts into which a span is cut. Halving a span halves its bend over its size.
int nParts(double bend, double size) {
    constexpr double flat = 0.1;
    constexpr int most = 16;
    int parts = 1;
    while (parts < most && bend > flat * parts * size) {
        parts *= 2;
    }
    return parts;
}

std::vector<double> cuts(const KnotVector& knots, const std::vector<int>& parts) {
    std::vector<double> added;
    for (int i = 0; i < knots.nSpans(); ++i) {
        const double from = knots.breakpoints()[i], to = knots.breakpoints()[i + 1];
        for (int j = 1; j < parts[i]; ++j) {
            added.push_back(from + (to - from) * j / parts[i]);
        }
    }
    return added;
}

} // namespace

std::vector<NurbsCurve> flatPieces(const NurbsCurve& curve) {
    std::vector<int> parts;
    for (const NurbsCurve& piece : bezierPieces(curve)) {
        const Points& points = piece.controlPoints();
        parts.push_back(
            nParts(bend(points, 0, 1, piece.nControlPoints()), Box::around(points).diagonal()));
    }
    return bezierPieces(insertKnots(curve, cuts(curve.knotVector(), parts)));
}

std::vector<NurbsSurface> flatPieces(const NurbsSurface& surface) {
    const int nSpansU = surface.u().nSpans(), nSpansV = surface.v().nSpans();
    const int nU = surface.u().degree() + 1, nV = surface.v().degree() + 1;
    std::vector<int> partsU(nSpansU, 1), partsV(nSpansV, 1);
    const std::vector<NurbsSurface> pieces = bezierPieces(surface);
    for (int span = 0; span < nSpansU * nSpansV; ++span) {
        const Points& points = pieces[span].controlPoints();
        const double size = Box::around(points).diagonal();
        double bendU = 0, bendV = 0;
        for (int j = 0; j < nV; ++j) {
            bendU = std::max(bendU, bend(points, nU * j, 1, nU));
        }
        for (int i = 0; i < nU; ++i) {
            bendV = std::max(bendV, bend(points, i, nU, nV));
        }
        int &inU = partsU[span % nSpansU], &inV = partsV[span / nSpansU];
        inU = std::max(inU, nParts(bendU, size));
        inV = std::max(inV, nParts(bendV, size));
    }
    return bezierPieces(insertKnots(surface, cuts(surface.u(), partsU), cuts(surface.v(), partsV)));
}

} // namespace tokay::geometry
