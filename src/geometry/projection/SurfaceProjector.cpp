// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/SurfaceProjector.hpp"

#include "geometry/projection/ClosestCandidate.hpp"
#include "geometry/projection/closestParameter.hpp"
#include "geometry/projection/flatPieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

struct ParameterRange {
    Parameters lower, upper;

    ParameterRange quarter(int i) const {
        const Parameters middle = 0.5 * (lower + upper);
        ParameterRange part{lower, middle};
        for (int axis = 0; axis < 2; ++axis) {
            if (i >> axis & 1) {
                part.lower[axis] = middle[axis];
                part.upper[axis] = upper[axis];
            }
        }
        return part;
    }
};

/// Search in one patch for the closest accepted place.
class AcceptedSearch {
  public:
    AcceptedSearch(const Point& point, double size, const SurfaceProjector::Acceptance& accepts,
                   double limit)
        : point_(point), size_(size), accepts_(accepts), squaredLimit_(limit * limit),
          candidate_(size) {}

    void search(const BezierPatch& patch) {
        search(patch, {patch.lower(), patch.upper()}, patch.guess(point_), 0);
    }

    /// Square of the distance beyond which a place changes nothing.
    double squaredLimit() const {
        return best_ ? std::min(squaredLimit_, candidate_.squaredLimit()) : squaredLimit_;
    }

    std::optional<SurfaceProjection> result() const {
        std::optional<SurfaceProjection> result = best_;
        if (result) {
            result->distance = candidate_.distance();
            result->ambiguous = candidate_.isAmbiguous();
        }
        return result;
    }

  private:
    /// Where the closest place is refused, another minimum near it may count:
    /// quarters are searched unless all of the range must be too far.
    void search(const BezierPatch& patch, const ParameterRange& range, const Parameters& start,
                int depth) {
        constexpr int deepest = 4;
        const ClosestParameter<2> found =
            closestParameter<2>([&](const Parameters& x) { return osculation(patch, x, point_); },
                                range.lower, range.upper, start, size_);
        const double limit = std::sqrt(squaredLimit());
        if (accepts_(found.parameter)) {
            if (found.offset.norm() <= limit && candidate_.offer(found.offset)) {
                best_ = {found.parameter[0], found.parameter[1], 0, found.converged, false};
            }
        } else if (depth < deepest && found.offset.norm() - diameter(patch, range) < limit) {
            for (int i = 0; i < 4; ++i) {
                const ParameterRange part = range.quarter(i);
                search(patch, part, 0.5 * (part.lower + part.upper), depth + 1);
            }
        }
    }

    /// Diameter of a part of a nearly flat patch, by its diagonals.
    static double diameter(const BezierPatch& patch, const ParameterRange& range) {
        const auto at = [&](double xi, double eta) -> Point {
            return patch.derivatives({xi, eta}).row(0);
        };
        const double first =
            (at(range.upper[0], range.upper[1]) - at(range.lower[0], range.lower[1])).norm();
        const double second =
            (at(range.lower[0], range.upper[1]) - at(range.upper[0], range.lower[1])).norm();
        return 1.25 * std::max(first, second);
    }

    const Point& point_;
    double size_;
    const SurfaceProjector::Acceptance& accepts_;
    double squaredLimit_;
    ClosestCandidate candidate_;
    std::optional<SurfaceProjection> best_;
};

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
    return *closest(
        point, [](const Parameters&) { return true; }, std::numeric_limits<double>::infinity());
}

std::optional<SurfaceProjection>
SurfaceProjector::closest(const Point& point, const Acceptance& accepts, double limit) const {
    const Point centred = point - centre_;
    AcceptedSearch search(centred, size_, accepts, limit);
    tree_->visitNearest(centred, [&](int piece) {
        search.search(pieces_[piece]);
        return search.squaredLimit();
    });
    return search.result();
}

} // namespace tokay::geometry
