// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/CovariantPoint.hpp"

#include "igaStructure/kinematics/shell/element/shellStrain.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>

namespace tokay::structure {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using geometry::derivativeRow;

namespace {

// Row of the derivative by the parameters a, b (and c).
int second(int a, int b) {
    return derivativeRow(2 - a - b, a + b);
}
int third(int a, int b, int c) {
    return derivativeRow(3 - a - b - c, a + b + c);
}

constexpr std::array<std::array<int, 2>, 3> pairs = {{{0, 0}, {1, 1}, {0, 1}}};

geometry::SurfaceBasis basisOf(const ShellPatch& patch, int element,
                               const geometry::Parameters& at) {
    const geometry::NurbsSurface& surface = patch.surface();
    const int nU = patch.patch().nElementsU();
    return geometry::spanBasis(
        surface, surface.u().findSpan(surface.u().breakpoints()[element % nU]),
        surface.v().findSpan(surface.v().breakpoints()[element / nU]), at[0], at[1], 3);
}

} // namespace

RowVectorXd timesVector(const RowVectorXd& functions, const Vector3d& vector) {
    RowVectorXd row(3 * functions.size());
    for (Eigen::Index k = 0; k < functions.size(); ++k) {
        row.segment<3>(3 * k) = functions[k] * vector.transpose();
    }
    return row;
}

CovariantPoint::CovariantPoint(const ShellPatch& patch, int element, const geometry::Parameters& at)
    : CovariantPoint(patch, basisOf(patch, element, at)) {}

CovariantPoint::CovariantPoint(const ShellPatch& patch, const geometry::SurfaceBasis& basis)
    : N(basis.N), X(basis.N * patch.surface().controlPoints()(basis.controlPoints, Eigen::all)) {
    for (const int k : basis.controlPoints) {
        nodes.push_back(patch.nodes()[k]);
    }
    for (int a = 0; a < 2; ++a) {
        A.col(a) = X.row(1 + a).transpose();
    }
    const Vector3d across = A.col(0).cross(A.col(1));
    A3 = across.normalized();
    inverse = Matrix2d(A.transpose() * A).inverse();
    const Eigen::Matrix<double, 3, 2> dual = A * inverse;
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
            const Vector3d Xab = X.row(second(a, b)).transpose();
            curvature(a, b) = Xab.dot(A3);
            christoffel[a][b] = dual.transpose() * Xab;
        }
    }
    mixed = inverse * curvature;
    findDerivatives(dual);
}

void CovariantPoint::findDerivatives(const Eigen::Matrix<double, 3, 2>& dual) {
    for (int c = 0; c < 2; ++c) {
        Eigen::Matrix<double, 3, 2> change; // A^s by c
        for (int s = 0; s < 2; ++s) {
            change.col(s) = mixed(s, c) * A3;
            for (int r = 0; r < 2; ++r) {
                change.col(s) -= christoffel[c][r][s] * dual.col(r);
            }
        }
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) {
                christoffelDerivative[a][b][c] =
                    dual.transpose() * X.row(third(a, b, c)).transpose() +
                    change.transpose() * X.row(second(a, b)).transpose();
            }
        }
    }
}

RowVectorXd CovariantPoint::twice(int a, int b) const {
    return N.row(second(a, b)) - christoffel[a][b][0] * N.row(1) - christoffel[a][b][1] * N.row(2);
}

RowVectorXd CovariantPoint::thrice(int a, int b, int c) const {
    RowVectorXd sum = N.row(third(a, b, c));
    for (int s = 0; s < 2; ++s) {
        sum -= christoffelDerivative[a][b][c][s] * N.row(1 + s) +
               christoffel[a][b][s] * N.row(second(s, c)) + christoffel[a][c][s] * twice(s, b) +
               christoffel[b][c][s] * twice(a, s);
    }
    return sum;
}

MatrixXd CovariantPoint::bendingRows() const {
    MatrixXd rows(3, N.cols());
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = pairs[k];
        rows.row(k) = -(a == b ? 1 : 2) * twice(a, b);
    }
    return rows;
}

MatrixXd CovariantPoint::bendingDerivativeRows(int c) const {
    MatrixXd rows(3, N.cols());
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = pairs[k];
        rows.row(k) = -(a == b ? 1 : 2) * thrice(a, b, c);
    }
    return rows;
}

MatrixXd CovariantPoint::membraneRows() const {
    MatrixXd rows(3, 3 * N.cols());
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = pairs[k];
        rows.row(k) = timesVector(N.row(1 + a), A.col(b));
        if (a != b) {
            rows.row(k) += timesVector(N.row(1 + b), A.col(a));
        }
    }
    return rows;
}

SectionResponse CovariantPoint::atRest(const ShellSection& section) const {
    SurfaceDerivatives position;
    position = X.middleRows(1, 5).transpose();
    return section.response(SurfacePoint(position).forms(), Vector6d::Zero());
}

} // namespace tokay::structure
