// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"
#include "geometry/spline/Points.hpp"

namespace tokay::geometry {

/// Functions, point and tangents of a surface at many parameters: no memory is
/// allocated, and what belongs to a knot span is gathered once while they stay in it.
class SurfaceEvaluator {
  public:
    /// Borrows the surface.
    explicit SurfaceEvaluator(const NurbsSurface& surface);

    /// Goes to the knot span that contains a location.
    void enter(const Parameters& place);
    /// Evaluates the polynomials of the present span, beyond its ends too: so
    /// rounding at a knot line makes no other list of functions.
    void evaluate(double xi, double eta);
    /// Both.
    void moveTo(double xi, double eta);

    /// Control points of the functions that are not zero there, as
    /// NurbsSurface::basis lists them, and the functions.
    const std::vector<int>& controlPoints() const { return controlPoints_; }
    const Eigen::VectorXd& N() const { return N_; }

    const Point& point() const { return point_; }
    const Point& tangentXi() const { return tangentXi_; }
    const Point& tangentEta() const { return tangentEta_; }
    /// Area in space over area in the parameters [m^2].
    double jacobian() const;

  private:
    void gather(int spanU, int spanV);

    const NurbsSurface& surface_;
    int spanU_ = -1, spanV_ = -1;
    std::vector<int> controlPoints_;
    /// Homogeneous control points, rows (w x, w y, w z, w); w is 1 if the surface is polynomial.
    Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> homogeneous_;
    Eigen::Matrix2Xd Nu_, Nv_;
    Eigen::VectorXd N_;
    Point point_, tangentXi_, tangentEta_;
};

} // namespace tokay::geometry
