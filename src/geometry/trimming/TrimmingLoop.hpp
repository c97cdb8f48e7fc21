// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bezier/PlaneBezier.hpp"
#include "geometry/quadrature/Polygon.hpp"
#include "geometry/spline/NurbsCurve.hpp"

namespace tokay::geometry {

enum class LoopKind { outer, inner };

/// Closed chain of curves in the parameter space of a surface, with what it
/// keeps on its left: an outer loop runs counter-clockwise, an inner one (the
/// rim of a hole) clockwise.
class TrimmingLoop {
  public:
    /// A gap between the end of a curve and the start of the next up to this
    /// fraction of the loop's extent, in each direction, is closed.
    static constexpr double closingTolerance = 1e-6;
    /// Parts of the loop nearer to each other than this fraction of its extent touch.
    static constexpr double touchingTolerance = 1e-10;

    /// @param curves  control points (xi, eta, any), each starting where the one
    ///                before it ends
    /// @throws InputError for a loop that is open, crosses or touches itself, has no
    /// area, or runs the wrong way round.
    TrimmingLoop(LoopKind kind, std::vector<NurbsCurve> curves);

    LoopKind kind() const { return kind_; }
    /// The curves, gaps closed.
    const std::vector<NurbsCurve>& curves() const { return curves_; }

    /// Bezier pieces of all curves in order, monotone in xi and in eta.
    const std::vector<PlaneBezier>& pieces() const { return pieces_; }
    const ParameterBox& box() const { return box_; }

    /// Enclosed area, positive for an outer loop, negative for an inner one; exact for
    /// polynomial curves, to rounding for rational ones.
    double signedArea() const;

    /// Winding number around a point that is not on the loop: 1, 0 or -1.
    int winding(const Parameters& point) const;

    /// Polygon on the loop; where the chords leave it by more than the
    /// tolerance (in units of the parameters, for each direction) it is finer.
    Polygon tessellated(const Parameters& chordTolerance) const;

    /// True if the loops cross or touch.
    bool meets(const TrimmingLoop& other) const;

    /// The loop around a rectangle: bottom, right, top, left.
    static TrimmingLoop around(const ParameterBox& box);

  private:
    LoopKind kind_;
    std::vector<NurbsCurve> curves_;
    std::vector<PlaneBezier> pieces_;
    ParameterBox box_;
};

} // namespace tokay::geometry
