// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"

namespace tokay::geometry {

/// Quadrature rules for cut elements.
enum class CutRule {
    /// Tiles with one curved side, Gauss points along it and across: no error
    /// for polynomial trimming curves, and for rational ones an error that falls
    /// exponentially with the number of points.
    boundaryExact,
    /// The loops become polygons, clipped with the element and cut into
    /// triangles: an error proportional to the chord tolerance, whatever the
    /// number of points.
    triangulated
};

/// @throws InputError that lists the names if there is no such rule.
CutRule cutRuleFromName(const std::string& name);

struct QuadratureOptions {
    /// Polynomials in xi and eta up to this degree in each are integrated
    /// exactly; 0 means twice the larger degree of the basis, a mass matrix in
    /// the parameters.
    int degree = 0;
    CutRule rule = CutRule::boundaryExact;
    /// boundaryExact: points along a curved side; 0 means as many as are exact
    /// for a polynomial trimming curve, and two more for a rational one.
    int nAlong = 0;
    /// triangulated: distance of a chord to the curve, in element sizes.
    double chordTolerance = 1e-3;
};

/// Integration points of the elements of a patch, cut ones included.
class PatchQuadrature {
  public:
    /// Borrows the patch.
    /// @throws InputError for options that make no sense.
    explicit PatchQuadrature(const TrimmedPatch& patch, const QuadratureOptions& options = {});

    /// Points inside the loops (triangulated: inside their polygons), of positive
    /// weight; none for an empty element.
    std::vector<ParameterPoint> points(int element) const;

    const TrimmedPatch& patch() const { return patch_; }

  private:
    std::vector<Polygon> region(int element) const;

    const TrimmedPatch& patch_;
    QuadratureOptions options_;
    /// triangulated: what the loops' polygons leave of each row of elements.
    std::vector<std::vector<Polygon>> rows_;
};

/// Area of an element's part, or of the whole patch, in space [m^2].
double area(const PatchQuadrature& quadrature, int element);
double area(const PatchQuadrature& quadrature);

} // namespace tokay::geometry
