// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/ModelProjector.hpp"

#include "geometry/projection/ClosestCandidate.hpp"

namespace tokay::geometry {

namespace {

ModelProjection projection(const SurfaceProjection& place, bool isOnRim) {
    return {0, place.xi, place.eta, place.distance, place.converged, place.ambiguous, isOnRim};
}

} // namespace

PatchProjector::PatchProjector(const TrimmedPatch& patch)
    : patch_(patch), surface_(patch.surface()), box_(Box::around(patch.surface().controlPoints())) {
    if (!patch.isTrimmed()) {
        return;
    }
    for (const TrimmingLoop& loop : patch.loops()) {
        for (const NurbsCurve& curve : loop.curves()) {
            curves_.emplace_back(curve, patch.surface());
        }
    }
}

bool PatchProjector::isOnRectangle(const SurfaceProjection& place) const {
    const ParameterBox box = patch_.box();
    return place.xi <= box.lower[0] || place.xi >= box.upper[0] || place.eta <= box.lower[1] ||
           place.eta >= box.upper[1];
}

ModelProjection PatchProjector::closest(const Point& point) const {
    const SurfaceProjection anywhere = surface_.closest(point);
    if (!patch_.isTrimmed() || patch_.contains({anywhere.xi, anywhere.eta})) {
        return projection(anywhere, isOnRectangle(anywhere));
    }
    // The closest place is trimmed away; another one inside, or the rim, is next.
    ModelProjection rim = closestOnLoops(point);
    const auto inside = surface_.closest(
        point, [&](const Parameters& at) { return patch_.contains(at); }, rim.distance);
    if (!inside) {
        return rim;
    }
    ClosestCandidate candidate(box_.diagonal());
    candidate.offer(patch_.surface().point(rim.xi, rim.eta) - point);
    candidate.offer(patch_.surface().point(inside->xi, inside->eta) - point);
    // A piece of the surface may end on the rim: that is the same place.
    const double rounding = 1e-12 * box_.diagonal();
    ModelProjection best =
        inside->distance < rim.distance - rounding ? projection(*inside, false) : rim;
    best.ambiguous = best.ambiguous || candidate.isAmbiguous();
    return best;
}

ModelProjection PatchProjector::closestOnLoops(const Point& point) const {
    ClosestCandidate candidate(box_.diagonal());
    ModelProjection best{};
    for (const CurveOnSurface& curve : curves_) {
        const CurveProjection found = curve.closest(point);
        const Point place = curve.derivatives(found.xi, 0).row(0);
        if (!candidate.offer(place - point)) {
            continue;
        }
        const Point at = curve.parameterCurve().point(found.xi);
        best = {0, at[0], at[1], found.distance, found.converged, found.ambiguous, true};
    }
    best.ambiguous = best.ambiguous || candidate.isAmbiguous();
    return best;
}

ModelProjector::ModelProjector(const BrepModel& model) : model_(model), size_(model.size()) {
    std::vector<Box> boxes;
    faces_.reserve(model.faces().size());
    for (const BrepFace& face : model.faces()) {
        faces_.emplace_back(face.patch);
        boxes.push_back(faces_.back().box());
    }
    tree_ = std::make_unique<BoxTree>(boxes);
}

ModelProjection ModelProjector::closest(const Point& point) const {
    ClosestCandidate candidate(size_);
    ModelProjection best{};
    tree_->visitNearest(point, [&](int face) {
        ModelProjection found = faces_[face].closest(point);
        const Point place = model_.patch(face).surface().point(found.xi, found.eta);
        if (candidate.offer(place - point)) {
            found.face = face;
            best = found;
        }
        return candidate.squaredLimit();
    });
    best.ambiguous = best.ambiguous || candidate.isAmbiguous();
    return best;
}

std::vector<ModelProjection> ModelProjector::closestOfAll(const Points& points) const {
    std::vector<ModelProjection> projections;
    projections.reserve(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        projections.push_back(closest(Point(points.row(i))));
    }
    return projections;
}

ProjectionSummary summary(const std::vector<ModelProjection>& projections) {
    ProjectionSummary summary;
    for (const ModelProjection& found : projections) {
        summary.nNotConverged += !found.converged;
        summary.nAmbiguous += found.ambiguous;
        summary.nOnRim += found.isOnRim;
        if (found.distance >= summary.largestDistance) {
            summary.largestDistance = found.distance;
            summary.farthestPoint = summary.nPoints;
        }
        ++summary.nPoints;
    }
    return summary;
}

} // namespace tokay::geometry
