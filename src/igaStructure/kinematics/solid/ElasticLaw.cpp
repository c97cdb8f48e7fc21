// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/ElasticLaw.hpp"

#include "common/errors.hpp"

#include <Eigen/LU>

#include <cmath>

namespace tokay::structure {

using Eigen::Matrix3d;

namespace {

constexpr int row[6] = {0, 1, 2, 0, 1, 0};
constexpr int column[6] = {0, 1, 2, 1, 2, 2};

Matrix6d isotropic(double lambda, double mu) {
    Matrix6d C = Matrix6d::Zero();
    C.topLeftCorner<3, 3>().setConstant(lambda);
    C.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
    return C;
}

Vector6d stressVector(const Matrix3d& stress) {
    Vector6d vector;
    for (int a = 0; a < 6; ++a) {
        vector[a] = stress(row[a], column[a]);
    }
    return vector;
}

// det(1 + D) - 1 without the loss of digits of small D.
double determinantLessOne(const Matrix3d& D) {
    const double second = 0.5 * (D.trace() * D.trace() - (D * D).trace());
    return D.trace() + second + D.determinant();
}

} // namespace

Matrix3d symmetricOfStress(const Vector6d& stress) {
    Matrix3d S;
    for (int a = 0; a < 6; ++a) {
        S(row[a], column[a]) = S(column[a], row[a]) = stress[a];
    }
    return S;
}

Vector6d strainVector(const Matrix3d& strain) {
    Vector6d vector = stressVector(strain);
    vector.tail<3>() *= 2;
    return vector;
}

ElasticLaw::ElasticLaw(const ElasticMaterial& material)
    : law_(material.law), lambda_(material.lambda()), mu_(material.mu()),
      stiffness_(isotropic(lambda_, mu_)) {
    if (law_ == MaterialLaw::incompressibleNeoHookean) {
        throw InputError("a solid cannot be incompressible: take neoHookean with a Poisson's ratio "
                         "below 0.5, such as 0.49");
    }
}

ElasticResponse ElasticLaw::linearResponse(const Matrix3d& strain) const {
    const Vector6d E = strainVector(strain);
    const Vector6d S = stiffness_ * E;
    return {S, stiffness_, 0.5 * E.dot(S)};
}

ElasticResponse ElasticLaw::response(const Matrix3d& strain) const {
    return law_ == MaterialLaw::neoHookean ? neoHookean(strain) : linearResponse(strain);
}

ElasticResponse ElasticLaw::neoHookean(const Matrix3d& strain) const {
    const Matrix3d inverse = (Matrix3d::Identity() + 2 * strain).inverse(); // of C
    const double logJ = 0.5 * std::log1p(determinantLessOne(2 * strain));
    ElasticResponse response;
    // mu (1 - C^-1) = 2 mu C^-1 E
    response.stress = stressVector(2 * mu_ * inverse * strain + lambda_ * logJ * inverse);
    const double shear = mu_ - lambda_ * logJ;
    for (int a = 0; a < 6; ++a) {
        const int i = row[a];
        const int j = column[a];
        for (int b = 0; b < 6; ++b) {
            const int k = row[b];
            const int l = column[b];
            response.tangent(a, b) =
                lambda_ * inverse(i, j) * inverse(k, l) +
                shear * (inverse(i, k) * inverse(j, l) + inverse(i, l) * inverse(j, k));
        }
    }
    response.energy = mu_ * (strain.trace() - logJ) + 0.5 * lambda_ * logJ * logJ;
    return response;
}

} // namespace tokay::structure
