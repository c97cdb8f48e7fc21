#pragma once

#include "geometry/CurveProjector.hpp"
#include "geometry/NurbsCurve.hpp"
#include "mapper/Discretisation.hpp"

namespace tokay::mapper {

/// One curve of a structure's wet boundary.
struct SplinePiece {
    geometry::NurbsCurve curve;
    /// Number of each control point of the curve in the structure.
    std::vector<int> controlPoints;
    /// For messages: "patch.edge".
    std::string name;
};

/// The wet boundary of a 2D structure: pieces that may share control points
/// (a corner). Values are the structure's control points, all of them, so that
/// mapped vectors need no renumbering.
class SplineInterface : public Discretisation {
  public:
    /// @param nControlPoints  of the whole structure
    /// @throws InputError if there is no piece, or a piece's numbers do not fit
    /// its curve or the structure, or pieces disagree on a shared control point.
    SplineInterface(std::vector<SplinePiece> pieces, int nControlPoints);

    const std::vector<SplinePiece>& pieces() const { return pieces_; }
    int nControlPoints() const { return static_cast<int>(coordinates_.rows()); }

    int nValues() const override { return nControlPoints(); }
    /// Rows of control points that are on no piece are zero.
    const Points& coordinates() const override { return coordinates_; }
    double size() const override { return size_; }
    Location locate(const Point& point) const override;

    struct Projection {
        int piece;
        geometry::CurveProjection onCurve;
    };
    /// The closest piece; where pieces meet, the one named first.
    Projection closest(const Point& point) const;

  private:
    std::vector<SplinePiece> pieces_;
    std::vector<geometry::CurveProjector> projectors_;
    Points coordinates_;
    double size_;
};

} // namespace tokay::mapper
