#include "geometry/SurfaceProjector.hpp"

#include "geometry/ClosestCandidate.hpp"
#include "geometry/closestParameter.hpp"
#include "geometry/flatPieces.hpp"

namespace tokay::geometry {

namespace {

using Parameters = Eigen::Vector2d;

Osculation<2> osculation(const BezierPatch& patch, const Parameters& x, const Point& point) {
    const BezierPatch::Derivatives d = patch.derivatives(x);
    Osculation<2> at;
    at.offset = d.row(0).transpose() - point;
    at.tangents << d.row(1).transpose(), d.row(2).transpose();
    at.curvature(0, 0) = d.row(derivativeRow(2, 0)).dot(at.offset);
    at.curvature(0, 1) = at.curvature(1, 0) = d.row(derivativeRow(1, 1)).dot(at.offset);
    at.curvature(1, 1) = d.row(derivativeRow(0, 2)).dot(at.offset);
    return at;
}

ClosestParameter<2> closestIn(const BezierPatch& patch, const Point& point, double size) {
    return closestParameter<2>([&](const Parameters& x) { return osculation(patch, x, point); },
                               patch.lower(), patch.upper(), patch.guess(point), size);
}

} // namespace

SurfaceProjector::SurfaceProjector(const NurbsSurface& surface) {
    const Box box = Box::around(surface.controlPoints());
    centre_ = box.centre();
    size_ = box.diagonal();
    const NurbsSurface centred =
        surface.withControlPoints(surface.controlPoints().rowwise() - centre_.transpose());
    std::vector<Box> boxes;
    for (const NurbsSurface& piece : flatPieces(centred)) {
        pieces_.emplace_back(piece);
        boxes.push_back(Box::around(piece.controlPoints()));
    }
    tree_ = std::make_unique<BoxTree>(boxes);
}

SurfaceProjection SurfaceProjector::closest(const Point& point) const {
    const Point centred = point - centre_;
    ClosestCandidate candidate(size_);
    SurfaceProjection best{pieces_.front().lower()[0], pieces_.front().lower()[1], 0, false, false};
    tree_->visitNearest(centred, [&](int piece) {
        const ClosestParameter<2> found = closestIn(pieces_[piece], centred, size_);
        if (candidate.offer(found.offset)) {
            best.xi = found.parameter[0];
            best.eta = found.parameter[1];
            best.converged = found.converged;
        }
        return candidate.squaredLimit();
    });
    best.distance = candidate.distance();
    best.ambiguous = candidate.isAmbiguous();
    return best;
}

} // namespace tokay::geometry
