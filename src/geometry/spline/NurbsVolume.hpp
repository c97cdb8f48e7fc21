// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"

namespace tokay::geometry {

/// Sides of the parameter box: left is the first xi, right the last xi, bottom
/// the first eta, top the last eta, back the first zeta, front the last zeta.
enum class Side { left, right, bottom, top, back, front };

/// @throws InputError that lists the names if there is no such side.
Side sideFromName(const std::string& name);
std::string nameOf(Side side);

/// The functions of a volume that are not zero at a parameter.
struct VolumeBasis {
    /// Control point of each column.
    std::vector<int> controlPoints;
    /// Rows N, N_xi, N_eta, N_zeta.
    Eigen::Matrix<double, 4, Eigen::Dynamic> N;
};

struct BoundarySurface {
    NurbsSurface surface;
    /// Number in the volume of each control point of the surface.
    std::vector<int> controlPoints;
    /// True if the surface's normal, xi x eta, points out of the volume.
    bool pointsOutwards;
};

/// Tensor-product volume in space; control point (i, j, k) has the number
/// i + nU (j + nV k), with i along xi, j along eta. Rational if there are weights.
class NurbsVolume {
  public:
    /// @param controlPoints  (nU nV nW) x 3 [m]
    /// @param weights        one a control point, positive; empty means polynomial.
    ///                       Equal weights are dropped.
    /// @throws InputError if counts do not agree, a coordinate is not finite or
    /// a weight is not positive.
    NurbsVolume(KnotVector u, KnotVector v, KnotVector w, Points controlPoints,
                Eigen::VectorXd weights = {});

    const KnotVector& u() const { return directions_[0]; }
    const KnotVector& v() const { return directions_[1]; }
    const KnotVector& w() const { return directions_[2]; }
    const KnotVector& direction(int axis) const { return directions_[axis]; }
    const Points& controlPoints() const { return controlPoints_; }
    /// Empty if the volume is polynomial.
    const Eigen::VectorXd& weights() const { return weights_; }
    bool isRational() const { return weights_.size() > 0; }
    int nControlPoints() const { return u().nBasis() * v().nBasis() * w().nBasis(); }

    Point point(const Eigen::Vector3d& parameters) const;
    /// Column i: derivative of the point by parameter i.
    Eigen::Matrix3d jacobian(const Eigen::Vector3d& parameters) const;

    /// Source: Piegl & Tiller, The NURBS Book, equation 4.20 for each function
    VolumeBasis basis(const Eigen::Vector3d& parameters) const;

    /// A side as a surface; its xi and eta are the volume's two others, in order.
    BoundarySurface boundarySurface(Side side) const;

  private:
    std::array<KnotVector, 3> directions_;
    Points controlPoints_;
    Eigen::VectorXd weights_;
};

} // namespace tokay::geometry
