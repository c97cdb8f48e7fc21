// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/shellStrain.hpp"

#include <Eigen/Geometry>

#include <array>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Column of SurfaceDerivatives of each curvature component (11, 22, 12), and how
// often the component counts.
constexpr std::array<int, 3> columnOf = {2, 4, 3};
constexpr std::array<double, 3> countOf = {1, 1, 2};

Vector3d finiteNormalChange(const SurfacePoint& reference, const SurfaceDerivatives& u) {
    const SurfaceDerivatives& A = reference.derivatives;
    const Vector3d& A3 = reference.normal.value();
    const double J0 = reference.normal.area();
    const Vector3d change =
        u.col(0).cross(A.col(1)) + A.col(0).cross(u.col(1)) + u.col(0).cross(u.col(1));
    const double J = (J0 * A3 + change).norm();
    const double stretch = change.dot(2 * J0 * A3 + change) / (J + J0);
    return (change - stretch * A3) / J;
}

Vector6d linearStrain(const SurfacePoint& reference, const SurfaceDerivatives& u) {
    const SurfaceDerivatives& A = reference.derivatives;
    Vector6d strain;
    strain << A.col(0).dot(u.col(0)), A.col(1).dot(u.col(1)),
        A.col(0).dot(u.col(1)) + A.col(1).dot(u.col(0)), 0, 0, 0;
    for (int k = 0; k < 3; ++k) {
        const Vector6d turn = reference.normal.gradient(A.col(columnOf[k]));
        strain[3 + k] = -countOf[k] * (u.col(columnOf[k]).dot(reference.normal.value()) +
                                       turn.head<3>().dot(u.col(0)) + turn.tail<3>().dot(u.col(1)));
    }
    return strain;
}

Vector6d nonlinearStrain(const SurfacePoint& reference, const SurfaceDerivatives& u) {
    const SurfaceDerivatives& A = reference.derivatives;
    const Vector3d u1 = u.col(0);
    const Vector3d u2 = u.col(1);
    Vector6d strain;
    strain << A.col(0).dot(u1) + 0.5 * u1.dot(u1), A.col(1).dot(u2) + 0.5 * u2.dot(u2),
        A.col(0).dot(u2) + A.col(1).dot(u1) + u1.dot(u2), 0, 0, 0;
    const Vector3d change = finiteNormalChange(reference, u);
    const Vector3d normal = reference.normal.value() + change;
    for (int k = 0; k < 3; ++k) {
        const int column = columnOf[k];
        strain[3 + k] = -countOf[k] * (u.col(column).dot(normal) + A.col(column).dot(change));
    }
    return strain;
}

// Sum of the second derivatives, each times its moment.
Vector3d momentVector(const SurfaceDerivatives& derivatives, const Vector6d& resultants) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += countOf[k] * resultants[3 + k] * derivatives.col(columnOf[k]);
    }
    return sum;
}

// Derivatives of the strains by the base vectors.
Matrix6d baseVectorRows(const SurfacePoint& point) {
    const SurfaceDerivatives& a = point.derivatives;
    Matrix6d rows = Matrix6d::Zero();
    rows.block<1, 3>(0, 0) = a.col(0).transpose();
    rows.block<1, 3>(1, 3) = a.col(1).transpose();
    rows.block<1, 3>(2, 0) = a.col(1).transpose();
    rows.block<1, 3>(2, 3) = a.col(0).transpose();
    for (int k = 0; k < 3; ++k) {
        rows.row(3 + k) = -countOf[k] * point.normal.gradient(a.col(columnOf[k])).transpose();
    }
    return rows;
}

void addStress(const SurfacePoint& current, const Vector6d& resultants, ShellHessian& hessian) {
    for (int c = 0; c < 3; ++c) {
        hessian(c, c) += resultants[0];
        hessian(3 + c, 3 + c) += resultants[1];
        hessian(c, 3 + c) += resultants[2];
        hessian(3 + c, c) += resultants[2];
    }
    hessian.topLeftCorner<6, 6>() -=
        current.normal.hessian(momentVector(current.derivatives, resultants));
    const Eigen::Matrix<double, 3, 6> turn = current.normal.derivative();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Matrix<double, 3, 6> block = countOf[k] * resultants[3 + k] * turn;
        hessian.block<3, 6>(3 * columnOf[k], 0) -= block;
        hessian.block<6, 3>(0, 3 * columnOf[k]) -= block.transpose();
    }
}

} // namespace

FundamentalForms SurfacePoint::forms() const {
    FundamentalForms forms;
    forms.metric << derivatives.col(0).squaredNorm(), derivatives.col(1).squaredNorm(),
        derivatives.col(0).dot(derivatives.col(1));
    for (int k = 0; k < 3; ++k) {
        forms.curvature[k] = derivatives.col(columnOf[k]).dot(normal.value());
    }
    return forms;
}

Vector6d shellStrain(const SurfacePoint& reference, const SurfaceDerivatives& displacement,
                     Strains kind) {
    return kind == Strains::linear ? linearStrain(reference, displacement)
                                   : nonlinearStrain(reference, displacement);
}

Vector3d normalChange(const SurfacePoint& reference, const SurfaceDerivatives& displacement,
                      Strains kind) {
    if (kind == Strains::nonlinear) {
        return finiteNormalChange(reference, displacement);
    }
    Vector6d baseVectors;
    baseVectors << displacement.col(0), displacement.col(1);
    return reference.normal.derivative() * baseVectors;
}

SurfaceDerivatives shellForce(const SurfacePoint& current, const Vector6d& resultants) {
    const SurfaceDerivatives& a = current.derivatives;
    const Vector6d turn = current.normal.gradient(momentVector(a, resultants));
    SurfaceDerivatives force;
    force.col(0) = resultants[0] * a.col(0) + resultants[2] * a.col(1) - turn.head<3>();
    force.col(1) = resultants[1] * a.col(1) + resultants[2] * a.col(0) - turn.tail<3>();
    for (int k = 0; k < 3; ++k) {
        force.col(columnOf[k]) = -countOf[k] * resultants[3 + k] * current.normal.value();
    }
    return force;
}

ShellHessian shellStiffness(const SurfacePoint& current, const Matrix6d& tangent,
                            const Vector6d& resultants) {
    const Vector3d& a3 = current.normal.value();
    const Matrix6d rows = baseVectorRows(current);
    const Matrix6d work = rows.transpose() * tangent;
    const Matrix3d square = a3 * a3.transpose();
    ShellHessian hessian;
    hessian.topLeftCorner<6, 6>().noalias() = work * rows;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Matrix<double, 6, 3> block = -countOf[k] * work.col(3 + k) * a3.transpose();
        hessian.block<6, 3>(0, 3 * columnOf[k]) = block;
        hessian.block<3, 6>(3 * columnOf[k], 0) = block.transpose();
        for (int l = 0; l < 3; ++l) {
            hessian.block<3, 3>(3 * columnOf[k], 3 * columnOf[l]) =
                countOf[k] * countOf[l] * tangent(3 + k, 3 + l) * square;
        }
    }
    if (!resultants.isZero(0)) {
        addStress(current, resultants, hessian);
    }
    return hessian;
}

} // namespace tokay::structure
