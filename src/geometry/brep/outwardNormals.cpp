// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/BrepModel.hpp"
#include "geometry/spline/curveParts.hpp"

namespace tokay::geometry {

namespace {

double mirrored(const KnotVector& u, double xi) {
    return u.first() + u.last() - xi;
}

KnotVector mirrored(const KnotVector& u) {
    std::vector<double> knots;
    for (auto knot = u.knots().rbegin(); knot != u.knots().rend(); ++knot) {
        knots.push_back(mirrored(u, *knot));
    }
    return {u.degree(), std::move(knots)};
}

/// The surface with xi reversed, so that its normal is.
NurbsSurface mirrored(const NurbsSurface& surface) {
    const int nU = surface.u().nBasis();
    std::vector<int> order;
    for (int k = 0; k < surface.nControlPoints(); ++k) {
        order.push_back(k - k % nU + (nU - 1 - k % nU));
    }
    const Points points = surface.controlPoints()(order, Eigen::all);
    const Eigen::VectorXd weights =
        surface.isRational() ? Eigen::VectorXd(surface.weights()(order)) : Eigen::VectorXd();
    return {mirrored(surface.u()), surface.v(), points, weights};
}

/// The same curve on the mirrored surface.
NurbsCurve mirrored(const NurbsCurve& curve, const KnotVector& u) {
    Points points = curve.controlPoints();
    points.col(0) = (u.first() + u.last() - points.col(0).array()).matrix();
    return curve.withControlPoints(points);
}

/// A mirrored loop, run through backwards: what it keeps stays on its left.
TrimmingLoop mirrored(const TrimmingLoop& loop, const KnotVector& u) {
    std::vector<NurbsCurve> curves;
    for (auto curve = loop.curves().rbegin(); curve != loop.curves().rend(); ++curve) {
        curves.push_back(reversed(mirrored(*curve, u)));
    }
    return {loop.kind(), std::move(curves)};
}

BrepFace mirrored(const BrepFace& face) {
    const KnotVector& u = face.patch.surface().u();
    std::vector<TrimmingLoop> loops;
    for (const TrimmingLoop& loop : face.patch.loops()) {
        loops.push_back(mirrored(loop, u));
    }
    BrepFace result{
        TrimmedPatch(mirrored(face.patch.surface()), std::move(loops), face.patch.name())};
    for (const NurbsCurve& curve : face.embeddedCurves) {
        result.embeddedCurves.push_back(mirrored(curve, u));
    }
    return result;
}

/// The trim of the mirrored face: the curves of each loop in reversed order and sense.
BrepTrim mirrored(const BrepTrim& trim, const TrimmedPatch& patch) {
    int first = 0; // curve of the loop
    for (const TrimmingLoop& loop : patch.loops()) {
        const int n = static_cast<int>(loop.curves().size());
        if (trim.curve < first + n) {
            return {trim.face, 2 * first + n - 1 - trim.curve, !trim.isForward};
        }
        first += n;
    }
    return trim; // embedded
}

} // namespace

BrepModel withOutwardNormals(const BrepModel& model) {
    std::vector<BrepFace> faces;
    for (const BrepFace& face : model.faces()) {
        faces.push_back(face.isNormalSwapped ? mirrored(face) : face);
    }
    std::vector<BrepEdge> edges = model.edges();
    for (BrepEdge& edge : edges) {
        for (BrepTrim& trim : edge.trims) {
            if (model.faces()[trim.face].isNormalSwapped) {
                trim = mirrored(trim, model.patch(trim.face));
            }
        }
    }
    return BrepModel(std::move(faces), std::move(edges), model.tolerance());
}

} // namespace tokay::geometry
