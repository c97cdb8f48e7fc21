// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "geometry/projection/CurveProjector.hpp"
#include "geometry/trimming/CurveOnSurface.hpp"
#include "mapper/Discretisation.hpp"

#include <memory>

namespace tokay::mapper {

/// A quadrature point of an element that an edge cuts: the weights are the functions'
/// derivatives along the surface, normal to the edge [1/m].
struct NormalSlope : Functions {
    double measure; ///< area that the point stands for [m^2]
    Point foot;     ///< closest place on the edge [m]
    Point normal;   ///< unit vector along the surface, across the edge
};

/// Curve of an interface, with the functions that live on it.
class InterfaceCurve {
  public:
    virtual ~InterfaceCurve() = default;

    /// Ends of its elements, ascending.
    virtual const std::vector<double>& breakpoints() const = 0;

    /// Degree of the functions along the curve, which quadrature has to match.
    virtual int degree() const = 0;

    /// @return (n + 1) x 3, n at most 2; row k is the k-th derivative by xi.
    virtual Points derivatives(double xi, int n) const = 0;

    virtual geometry::CurveProjection closest(const Point& point) const = 0;

    virtual Functions functions(double xi) const = 0;

    virtual geometry::Box box() const = 0;

    /// The functions' derivatives along a direction at a place of the curve [1/m]; none if
    /// they are known on the curve only.
    virtual Functions slope(double /*xi*/, const Point& /*direction*/) const { return {}; }

    /// Normal slopes in the whole elements that the curve cuts or, along a knot line, touches; none
    /// if the curve is not the edge of a patch.
    virtual std::vector<NormalSlope> normalSlopes() const { return {}; }
};

/// A NURBS curve whose control points have numbers; with degree 1, line elements.
std::unique_ptr<InterfaceCurve> interfaceCurve(const geometry::NurbsCurve& curve,
                                               std::vector<int> controlPoints);

/// A line element of a finite volume mesh, with a value that is constant over it.
std::unique_ptr<InterfaceCurve> interfaceCell(const geometry::NurbsCurve& line, int value);

/// An edge of a trimmed patch: all functions of the surface that do not vanish on it.
/// @param controlPoints  number of each control point of the surface
std::unique_ptr<InterfaceCurve> interfaceCurve(geometry::CurveOnSurface curve,
                                               std::vector<int> controlPoints);

} // namespace tokay::mapper
