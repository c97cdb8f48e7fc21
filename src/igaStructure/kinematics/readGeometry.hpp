// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::structure {

class CaseSection;

/// The surface of `geometry` in the basis of `discretisation`.
/// @throws InputError if the entries do not fit each other or describe no surface
geometry::NurbsSurface readSurface(const CaseSection& file);

/// The curve of `geometry` in the basis of `discretisation`; as readSurface.
geometry::NurbsCurve readCurve(const CaseSection& file);

/// 3 if `geometry` gives a point of its curve with a z, be it 0; else 2.
int curveDimension(const CaseSection& file);

/// Whether edges of the geometry that coincide stay open.
bool isSlit(const CaseSection& file);

/// A list of coordinates; z is 0 if not given.
/// @throws InputError if it has not 2 or 3 values
geometry::Point readCoordinates(const CaseSection& section, const std::string& name);

/// The rectangle or NURBS patch that `geometry` names, as it is.
geometry::NurbsSurface readUnrefinedSurface(const CaseSection& geometry);

/// Control points and weights of a `nurbs` map: z is 0 if not given; no weights mean polynomial.
geometry::Points readControlPoints(const CaseSection& nurbs);
Eigen::VectorXd readWeights(const CaseSection& nurbs);

} // namespace tokay::structure
