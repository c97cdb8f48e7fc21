// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsVolume.hpp"

namespace tokay::geometry {

/// Refinements change the basis, never the geometry (rational ones included).

/// @param knots  parameters to insert, ascending, each as often as it shall be added
/// @throws InputError if a knot lies outside the range or gets too multiple.
NurbsCurve insertKnots(const NurbsCurve& curve, const std::vector<double>& knots);

/// The inverse of insertKnots, where the curve is smooth enough for it.
/// @param knots      parameters, ascending, each as often as it shall go
/// @param tolerance  by how far the control points of the curve may be off when the
///                   knots are inserted again, relative to their extent
/// @throws InputError if a knot is not there so often, or the curve would change.
NurbsCurve removeKnots(const NurbsCurve& curve, const std::vector<double>& knots,
                       double tolerance = 1e-10);

/// Raises the degree; every knot's multiplicity grows with it, so the
/// continuity stays.
/// @throws InputError if by is negative.
NurbsCurve elevateDegree(const NurbsCurve& curve, int by);

/// Raises the degree to the given one, then cuts every knot span into
/// nDivisions equal parts (k-refinement).
/// @throws InputError if the degree is below the curve's or nDivisions below 1.
NurbsCurve refine(const NurbsCurve& curve, int degree, int nDivisions);

NurbsSurface insertKnots(const NurbsSurface& surface, const std::vector<double>& knotsU,
                         const std::vector<double>& knotsV);

NurbsSurface removeKnots(const NurbsSurface& surface, const std::vector<double>& knotsU,
                         const std::vector<double>& knotsV, double tolerance = 1e-10);

NurbsSurface elevateDegree(const NurbsSurface& surface, int byU, int byV);

/// Raises degrees and cuts spans in both directions: a surface of one span, as the
/// primitives make them, gets nDivisionsU x nDivisionsV knot spans.
NurbsSurface refine(const NurbsSurface& surface, int degreeU, int degreeV, int nDivisionsU,
                    int nDivisionsV);

NurbsVolume insertKnots(const NurbsVolume& volume, const std::array<std::vector<double>, 3>& knots);

NurbsVolume elevateDegree(const NurbsVolume& volume, const std::array<int, 3>& by);

/// Raises degrees and cuts spans in all three directions.
NurbsVolume refine(const NurbsVolume& volume, const std::array<int, 3>& degrees,
                   const std::array<int, 3>& nDivisions);

} // namespace tokay::geometry
