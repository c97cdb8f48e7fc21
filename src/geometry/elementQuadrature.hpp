#pragma once

#include "geometry/TrimmedPatch.hpp"

namespace tokay::geometry {

/// A quadrature point in the parameter space of a patch.
struct ParameterPoint {
    double xi, eta;
    /// Of the parameter area; negative where parts of a cut element overlap and
    /// cancel.
    double weight;
};

/// Points that integrate polynomials of the degree (in each parameter; in total
/// for cut elements) over the element's part of the patch. Cut elements are
/// integrated over the polygons of the tessellated loops, cut into triangles
/// with sign: exact for the polygons, holes and slivers included.
std::vector<ParameterPoint> elementQuadrature(const TrimmedPatch& patch, int element, int degree);

/// The same over the part of a convex cell in parameter space.
std::vector<ParameterPoint> cellQuadrature(const std::vector<Polygon>& parts, int degree);

} // namespace tokay::geometry
