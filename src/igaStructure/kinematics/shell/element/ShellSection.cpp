// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/ShellSection.hpp"

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d contravariant(const Vector3d& metric) {
    const double determinant = metric[0] * metric[1] - metric[2] * metric[2];
    return Vector3d(metric[1], metric[0], -metric[2]) / determinant;
}

namespace {

// Plane stress, divided by E / (1 - nu^2): nu A^ab A^cd + (1 - nu)(A^ac A^bd + A^ad A^bc) / 2.
Matrix3d planeStress(const Vector3d& A, double nu) {
    Matrix3d C;
    C(0, 0) = A[0] * A[0];
    C(1, 1) = A[1] * A[1];
    C(2, 2) = 0.5 * ((1 - nu) * A[0] * A[1] + (1 + nu) * A[2] * A[2]);
    C(0, 1) = C(1, 0) = nu * A[0] * A[1] + (1 - nu) * A[2] * A[2];
    C(0, 2) = C(2, 0) = A[0] * A[2];
    C(1, 2) = C(2, 1) = A[1] * A[2];
    return C;
}

} // namespace

LinearSection::LinearSection(const ElasticMaterial& material, double thickness)
    : poissonsRatio_(material.poissonsRatio),
      membraneStiffness_(material.planeStressModulus() * thickness),
      bendingStiffness_(membraneStiffness_ * thickness * thickness / 12) {}

SectionResponse LinearSection::response(const FundamentalForms& reference,
                                        const Vector6d& strains) const {
    const Matrix3d C = planeStress(contravariant(reference.metric), poissonsRatio_);
    SectionResponse response;
    response.tangent.topLeftCorner<3, 3>() = membraneStiffness_ * C;
    response.tangent.bottomRightCorner<3, 3>() = bendingStiffness_ * C;
    response.resultants.head<3>() = membraneStiffness_ * (C * strains.head<3>());
    response.resultants.tail<3>() = bendingStiffness_ * (C * strains.tail<3>());
    response.energy = 0.5 * strains.dot(response.resultants);
    return response;
}

} // namespace tokay::structure
