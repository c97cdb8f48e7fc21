#include "mapper/SplineInterface.hpp"

#include "common/errors.hpp"
#include "geometry/ClosestCandidate.hpp"
#include <fmt/format.h>

namespace tokay::mapper {

namespace {

void checkNumbers(const SplinePiece& piece, int nControlPoints) {
    const int n = piece.curve.nControlPoints();
    if (static_cast<int>(piece.controlPoints.size()) != n)
        throw InputError(fmt::format("The interface piece {} has {} control point numbers for a "
                                     "curve of {} control points.",
                                     piece.name, piece.controlPoints.size(), n));
    for (const int number : piece.controlPoints)
        if (number < 0 || number >= nControlPoints)
            throw InputError(fmt::format("The interface piece {} names the control point {}, but "
                                         "the structure has {} (numbers start at 0).",
                                         piece.name, number, nControlPoints));
}

geometry::Box boxOf(const std::vector<SplinePiece>& pieces) {
    geometry::Box box = geometry::Box::empty();
    for (const SplinePiece& piece : pieces)
        box.include(geometry::Box::around(piece.curve.controlPoints()));
    return box;
}

/// Coordinates by the structure's numbers.
Points gathered(const std::vector<SplinePiece>& pieces, int nControlPoints, double size) {
    Points coordinates = Points::Zero(nControlPoints, 3);
    std::vector<bool> isKnown(nControlPoints, false);
    for (const SplinePiece& piece : pieces)
        for (int i = 0; i < piece.curve.nControlPoints(); ++i) {
            const int number = piece.controlPoints[i];
            const auto here = piece.curve.controlPoints().row(i);
            const double distance = (coordinates.row(number) - here).norm();
            if (isKnown[number] && distance > 1e-9 * size)
                throw InputError(fmt::format("Control point {} is shared by interface pieces, but "
                                             "in {} it lies {:.3g} m from where the pieces before "
                                             "have it.",
                                             number, piece.name, distance));
            coordinates.row(number) = here;
            isKnown[number] = true;
        }
    return coordinates;
}

} // namespace

SplineInterface::SplineInterface(std::vector<SplinePiece> pieces, int nControlPoints)
    : pieces_(std::move(pieces)) {
    if (pieces_.empty())
        throw InputError("The interface has no piece: name at least one edge.");
    for (const SplinePiece& piece : pieces_) {
        checkNumbers(piece, nControlPoints);
        projectors_.emplace_back(piece.curve);
    }
    size_ = boxOf(pieces_).diagonal();
    coordinates_ = gathered(pieces_, nControlPoints, size_);
}

SplineInterface::Projection SplineInterface::closest(const Point& point) const {
    geometry::ClosestCandidate candidate(size_);
    Projection best{};
    bool isAmbiguous = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const geometry::CurveProjection found = projectors_[i].closest(point);
        const Point place = pieces_[i].curve.point(found.xi);
        if (candidate.offer(place - point)) {
            best = {static_cast<int>(i), found};
            isAmbiguous = found.ambiguous;
        }
    }
    best.onCurve.ambiguous = isAmbiguous || candidate.isAmbiguous();
    return best;
}

Location SplineInterface::locate(const Point& point) const {
    const Projection projection = closest(point);
    const SplinePiece& piece = pieces_[projection.piece];
    const geometry::CurveBasis basis = piece.curve.basis(projection.onCurve.xi, 0);
    Location location;
    for (int j = 0; j < basis.N.cols(); ++j)
        location.values.push_back(piece.controlPoints[basis.first + j]);
    location.weights = basis.N.row(0);
    location.gap = projection.onCurve.distance;
    location.converged = projection.onCurve.converged;
    location.ambiguous = projection.onCurve.ambiguous;
    return location;
}

} // namespace tokay::mapper
