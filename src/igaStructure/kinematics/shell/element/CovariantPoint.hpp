// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"
#include "igaStructure/kinematics/shell/element/ShellSection.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

/// A surface at a place with its Christoffel symbols and their derivatives, and what
/// covariant derivatives do to a function on it. Pairs are (11, 22, 12).
class CovariantPoint {
  public:
    /// @param element  whose functions are taken, beyond its rim too
    CovariantPoint(const ShellPatch& patch, int element, const geometry::Parameters& at);

    /// N|ab for all functions.
    Eigen::RowVectorXd twice(int a, int b) const;
    /// N|abc.
    Eigen::RowVectorXd thrice(int a, int b, int c) const;
    /// Derivative of the unit normal.
    Eigen::Vector3d normalDerivative(int a) const { return -A * mixed.col(a); }
    double area() const { return A.col(0).cross(A.col(1)).norm(); }

    /// (k11, k22, 2 k12) = -N|ab, linear, of functions times the normal; n columns.
    Eigen::MatrixXd bendingRows() const;
    /// Covariant derivative of bendingRows() by c.
    Eigen::MatrixXd bendingDerivativeRows(int c) const;
    /// (E11, E22, 2 E12), linear; component c of node k is column 3 k + c.
    Eigen::MatrixXd membraneRows() const;

    /// Response of the section at rest.
    SectionResponse atRest(const ShellSection& section) const;

    std::vector<int> nodes;
    Eigen::MatrixXd N; ///< of derivatives up to the third, as geometry::derivativeRow
    Eigen::MatrixXd X; ///< of the position; rows as of N
    Eigen::Matrix<double, 3, 2> A;
    Eigen::Vector3d A3;
    Eigen::Matrix2d inverse;   ///< of the metric
    Eigen::Matrix2d curvature; ///< b_ab
    Eigen::Matrix2d mixed;     ///< b^c_a: row c, column a

  private:
    CovariantPoint(const ShellPatch& patch, const geometry::SurfaceBasis& basis);
    void findDerivatives(const Eigen::Matrix<double, 3, 2>& dual);

    Eigen::Vector2d christoffel[2][2];
    Eigen::Vector2d christoffelDerivative[2][2][2];
};

/// Index of a symmetric pair among (11, 22, 12).
constexpr int symmetricPair(int a, int b) {
    return a == b ? a : 2;
}

/// A row with three columns a function: each function times each component.
Eigen::RowVectorXd timesVector(const Eigen::RowVectorXd& functions, const Eigen::Vector3d& vector);

} // namespace tokay::structure
