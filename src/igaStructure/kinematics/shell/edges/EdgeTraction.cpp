// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/EdgeTraction.hpp"

#include "igaStructure/kinematics/shell/element/CovariantPoint.hpp"

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// (k11, k22, 2 k12), of displacement in any direction.
MatrixXd curvatureRows(const CovariantPoint& at) {
    const MatrixXd bending = at.bendingRows();
    MatrixXd rows(3, 3 * bending.cols());
    for (int k = 0; k < 3; ++k) {
        rows.row(k) = timesVector(bending.row(k), at.A3);
    }
    return rows;
}

// Their covariant derivative by c.
MatrixXd curvatureDerivativeRows(const CovariantPoint& at, int c) {
    const MatrixXd bending = at.bendingRows();
    const MatrixXd derivative = at.bendingDerivativeRows(c);
    MatrixXd rows(3, 3 * bending.cols());
    for (int k = 0; k < 3; ++k) {
        rows.row(k) = timesVector(derivative.row(k), at.A3) +
                      timesVector(bending.row(k), at.normalDerivative(c));
    }
    return rows;
}

} // namespace

EdgeTraction::EdgeTraction(const PatchLocation& place, int element, bool bending) {
    // The geometry is that of the place; the sliver's own is the same surface.
    const CovariantPoint at(*place.patch, element, place.parameters);
    nodes = at.nodes;
    const Vector2d outwards = (at.A.transpose() * at.A) * place.conormal();
    const SectionResponse rest = at.atRest(place.patch->section());

    const MatrixXd n = rest.tangent.topLeftCorner<3, 3>() * at.membraneRows();
    force = MatrixXd::Zero(3, n.cols());
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
            force += outwards[a] * at.A.col(b) * n.row(symmetricPair(a, b));
            for (int i = 0; i < 3; ++i) {
                force.row(i) += outwards[a] * rest.resultants[symmetricPair(a, b)] *
                                timesVector(at.N.row(1 + b), Vector3d::Unit(i));
            }
        }
    }
    twist = MatrixXd::Zero(3, n.cols());
    moment = RowVectorXd::Zero(n.cols());
    if (!bending) {
        return;
    }
    const Eigen::Matrix3d C = rest.tangent.bottomRightCorner<3, 3>();
    const MatrixXd m = C * curvatureRows(at);
    const MatrixXd derivatives[2] = {C * curvatureDerivativeRows(at, 0),
                                     C * curvatureDerivativeRows(at, 1)};
    const Vector2d along = (at.A.transpose() * at.A) * place.tangent;
    RowVectorXd twisting = RowVectorXd::Zero(n.cols());
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
            const auto row = m.row(symmetricPair(a, b));
            force += outwards[a] * at.normalDerivative(b) * row;
            force += outwards[a] * at.A3 * derivatives[b].row(symmetricPair(a, b));
            moment += outwards[a] * outwards[b] * row;
            twisting += outwards[a] * along[b] * row;
        }
    }
    twist = -at.A3 * twisting;
}

} // namespace tokay::structure
