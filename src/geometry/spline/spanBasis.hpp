// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// As NurbsSurface::basis with the functions of given knot spans, whose polynomials
/// go on outside of them.
SurfaceBasis spanBasis(const NurbsSurface& surface, int spanU, int spanV, double xi, double eta,
                       int nDerivatives);

} // namespace tokay::geometry
