// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "mapper/interface/CurveInterface.hpp"

namespace tokay::mapper {

/// Curve of a structure's wet boundary.
struct SplinePiece {
    geometry::NurbsCurve curve;
    /// Number of each control point of the curve in the structure.
    std::vector<int> controlPoints;
    /// Name of the curve, for messages: "patch.edge".
    std::string name;
};

/// The wet boundary of a 2D structure: pieces that may share control points
/// (a corner). Values are the structure's control points, all of them, so that
/// mapped vectors need no renumbering.
class SplineInterface : public CurveInterface {
  public:
    /// @param nControlPoints  of the whole structure
    /// @throws InputError if there is no piece, or a piece's numbers do not fit
    /// its curve or the structure, or pieces disagree on a shared control point.
    SplineInterface(std::vector<SplinePiece> pieces, int nControlPoints);

    const std::vector<SplinePiece>& pieces() const { return pieces_; }
    int nControlPoints() const { return nValues(); }

  private:
    std::vector<SplinePiece> pieces_;
};

} // namespace tokay::mapper
