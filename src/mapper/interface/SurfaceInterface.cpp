// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/SurfaceInterface.hpp"

#include "common/errors.hpp"
#include "geometry/projection/ClosestCandidate.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

using geometry::Box;
using geometry::NurbsSurface;

namespace {

void checkNumbers(const SurfacePiece& piece, int nControlPoints) {
    const int n = piece.patch.basis().nControlPoints();
    if (static_cast<int>(piece.controlPoints.size()) != n) {
        throw InputError(fmt::format("the interface patch {} has {} control point numbers for a "
                                     "surface of {} control points",
                                     piece.name, piece.controlPoints.size(), n));
    }
    for (const int number : piece.controlPoints) {
        if (number < 0 || number >= nControlPoints) {
            throw InputError(
                fmt::format("the interface patch {} names the control point {}, but the "
                            "structure has {} (indices start at 0)",
                            piece.name, number, nControlPoints));
        }
    }
}

/// True if two opposite edges are the same curve.
bool coincide(const NurbsSurface& surface, geometry::Edge a, geometry::Edge b) {
    const Points first = surface.boundaryCurve(a).curve.controlPoints();
    const Points last = surface.boundaryCurve(b).curve.controlPoints();
    const double size = Box::around(surface.controlPoints()).diagonal();
    return (first - last).rowwise().norm().maxCoeff() <= 1e-12 * size;
}

} // namespace

SurfaceInterface::SurfaceInterface(std::vector<SurfacePiece> pieces, int nControlPoints)
    : pieces_(std::move(pieces)), firstElement_{0}, coordinates_(Points::Zero(nControlPoints, 3)) {
    if (pieces_.empty()) {
        throw InputError("the interface has no patch: name at least one");
    }
    Box all = Box::empty();
    for (const SurfacePiece& piece : pieces_) {
        checkNumbers(piece, nControlPoints);
        const NurbsSurface& surface = piece.patch.basis();
        projectors_.emplace_back(surface);
        addRim(piece.patch);
        boxes_.push_back(Box::around(surface.controlPoints()));
        all.include(boxes_.back());
        isClosed_.push_back({coincide(surface, geometry::Edge::left, geometry::Edge::right),
                             coincide(surface, geometry::Edge::bottom, geometry::Edge::top)});
        poles_.push_back(geometry::surfacePoles(surface));
        firstElement_.push_back(firstElement_.back() + piece.patch.nElements());
        for (int i = 0; i < surface.nControlPoints(); ++i) {
            coordinates_.row(piece.controlPoints[i]) = surface.controlPoints().row(i);
        }
    }
    size_ = all.diagonal();
    tree_ = std::make_unique<geometry::BoxTree>(boxes_);
}

void SurfaceInterface::addRim(const geometry::TrimmedPatch& patch) {
    Rim& rim = rims_.emplace_back();
    if (!patch.isTrimmed()) {
        return;
    }
    std::vector<Box> boxes;
    for (const geometry::TrimmingLoop& loop : patch.loops()) {
        for (const geometry::NurbsCurve& curve : loop.curves()) {
            rim.curves.emplace_back(curve, patch.basis());
            boxes.push_back(rim.curves.back().box());
        }
    }
    rim.tree = std::make_unique<geometry::BoxTree>(boxes);
}

geometry::SurfaceProjection SurfaceInterface::closestOn(int piece, const Point& point) const {
    geometry::SurfaceProjection onSurface = projectors_[piece].closest(point);
    const geometry::TrimmedPatch& patch = pieces_[piece].patch;
    if (!patch.isTrimmed() || patch.contains({onSurface.xi, onSurface.eta})) {
        return onSurface;
    }
    geometry::ClosestCandidate candidate(size_);
    rims_[piece].tree->visitNearest(point, [&](int i) {
        const geometry::CurveOnSurface& curve = rims_[piece].curves[i];
        const geometry::CurveProjection onCurve = curve.closest(point);
        const Point place = curve.derivatives(onCurve.xi, 0).row(0);
        if (candidate.offer(place - point)) {
            const Point parameters = curve.parameterCurve().point(onCurve.xi);
            onSurface = {parameters[0], parameters[1], onCurve.distance, onCurve.converged,
                         onCurve.ambiguous};
        }
        return candidate.squaredLimit();
    });
    onSurface.ambiguous = onSurface.ambiguous || candidate.isAmbiguous();
    return onSurface;
}

SurfaceInterface::Projection SurfaceInterface::closest(const Point& point) const {
    geometry::ClosestCandidate candidate(size_);
    Projection best{};
    tree_->visitNearest(point, [&](int i) {
        const geometry::SurfaceProjection found = closestOn(i, point);
        const Point place = pieces_[i].patch.basis().point(found.xi, found.eta);
        if (candidate.offer(place - point)) {
            best = {i, found};
        }
        return candidate.squaredLimit();
    });
    best.onSurface.ambiguous = best.onSurface.ambiguous || candidate.isAmbiguous();
    return best;
}

Functions SurfaceInterface::functions(int piece, double xi, double eta) const {
    geometry::SurfaceBasis basis = pieces_[piece].patch.basis().basis(xi, eta, 0);
    for (int& number : basis.controlPoints) {
        number = pieces_[piece].controlPoints[number];
    }
    return {std::move(basis.controlPoints), basis.N.row(0)};
}

Location SurfaceInterface::locate(const Point& point) const {
    const Projection found = closest(point);
    const geometry::SurfaceProjection& at = found.onSurface;
    return {functions(found.piece, at.xi, at.eta), at.distance, at.converged, at.ambiguous};
}

} // namespace tokay::mapper
