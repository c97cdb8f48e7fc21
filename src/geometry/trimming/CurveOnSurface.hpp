// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "geometry/projection/CurveProjector.hpp"
#include "geometry/spline/NurbsSurface.hpp"

#include <memory>

namespace tokay::geometry {

/// A curve in the parameter space of a surface, seen as a curve in space: an
/// edge of a trimmed patch.
class CurveOnSurface {
  public:
    /// @param parameterCurve  control points (xi, eta, 0) of the surface
    /// @throws InputError if the curve leaves the surface's parameter range.
    CurveOnSurface(NurbsCurve parameterCurve, NurbsSurface surface);

    const NurbsCurve& parameterCurve() const { return curve_; }
    const NurbsSurface& surface() const { return surface_; }

    /// The curve's own breakpoints and where it crosses the surface's knot
    /// lines: between two of them everything is smooth.
    const std::vector<double>& breakpoints() const { return breakpoints_; }

    /// @return (n + 1) x 3, n at most 2; row k is the k-th derivative by t.
    Points derivatives(double t, int n) const;

    CurveProjection closest(const Point& point) const;

    const Box& box() const { return box_; }

  private:
    struct Segment {
        double from, to;
    };
    void buildTree();

    NurbsCurve curve_;
    NurbsSurface surface_;
    /// The surface moved to its centre: far from the origin no digits are lost.
    Point centre_;
    NurbsSurface centred_;
    double size_;
    std::vector<double> breakpoints_;
    std::vector<Segment> segments_;
    std::unique_ptr<BoxTree> tree_;
    Box box_;
};

} // namespace tokay::geometry
