// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/TractionBounds.hpp"

#include "common/dense/SingularValues.hpp"
#include "igaStructure/assembly/GeometryError.hpp"
#include "igaStructure/kinematics/shell/element/CovariantPoint.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

void TractionBounds::enlarge(const TractionBounds& other) {
    membrane = std::max(membrane, other.membrane);
    shear = std::max(shear, other.shear);
    twist = std::max(twist, other.twist);
    moment = std::max(moment, other.moment);
}

namespace {

// visit(parameters, weight in the parameters) at the quadrature points of an element.
template <class Visit>
void forEachPoint(const ShellPatch& patch, int element, Visit visit) {
    if (patch.patch().state(element) == geometry::ElementState::cut) {
        for (const ShellPatch::CutPoint& point : patch.cutPoints(element)) {
            visit(geometry::Parameters(point.xi, point.eta), point.weight);
        }
        return;
    }
    const int i = element % patch.u().nSpans();
    const int j = element / patch.u().nSpans();
    for (int b = 0; b < patch.v().nPointsPerSpan(); ++b) {
        for (int a = 0; a < patch.u().nPointsPerSpan(); ++a) {
            visit(geometry::Parameters(patch.u().parameter(i, a), patch.v().parameter(j, b)),
                  patch.u().weight(i, a) * patch.v().weight(j, b));
        }
    }
}

// Matrices one below the other.
class Stack {
  public:
    void add(MatrixXd rows) { parts_.push_back(std::move(rows)); }
    bool empty() const { return parts_.empty(); }
    MatrixXd matrix() const {
        Eigen::Index n = 0;
        for (const MatrixXd& part : parts_) {
            n += part.rows();
        }
        MatrixXd all(n, parts_.front().cols());
        n = 0;
        for (const MatrixXd& part : parts_) {
            all.middleRows(n, part.rows()) = part;
            n += part.rows();
        }
        return all;
    }

  private:
    std::vector<MatrixXd> parts_;
};

// Rows whose square is twice the energy density.
MatrixXd root(const Matrix3d& stiffness, const MatrixXd& strains) {
    return Matrix3d(stiffness.llt().matrixL()).transpose() * strains;
}

// Motions of an element with an energy of one half each, that span all it has but
// those without energy.
MatrixXd unitMotions(const ShellPatch& patch, const MatrixXd& energyRoot, const PatchLocation& at) {
    const double largest = energyRoot.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !std::isfinite(largest)) {
        throw GeometryError(
            fmt::format("patch \"{}\" has no usable shape at its edge near ({:.6g}, {:.6g}, "
                        "{:.6g}): lengths of "
                        "its element there differ too much, or vanish; correct its control points",
                        patch.patch().name(), at.position[0], at.position[1], at.position[2]));
    }
    // What is left of a rigid motion's energy; its tractions are as small.
    constexpr double rounding = 1e-12;
    const SingularValues parts(energyRoot);
    const Eigen::Index rank = parts.rank(rounding);
    return parts.V.leftCols(rank) * parts.values.head(rank).cwiseInverse().asDiagonal();
}

double largestSquare(const MatrixXd& rows) {
    if (rows.size() == 0) {
        return 0;
    }
    const double norm = SingularValues(rows).values[0];
    return norm * norm;
}

// An element's energy and its tractions, as rows by the motions that are looked at.
struct Tractions {
    Stack energyRoot, membrane, shear, twist, moment;
};

// By displacement in a plane, two columns a function.
Tractions ofMembrane(const ShellPatch& patch, int element, const std::vector<EdgePiece>& edge) {
    const CovariantPoint first(patch, element, edge.front().place->parameters);
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = first.A.col(0).normalized();
    plane.col(1) = first.A3.cross(plane.col(0));
    const auto strains = [&](const CovariantPoint& at) {
        const MatrixXd all = at.membraneRows();
        MatrixXd rows(3, 2 * at.N.cols());
        for (Eigen::Index k = 0; k < at.N.cols(); ++k) {
            rows.middleCols<2>(2 * k) = all.middleCols<3>(3 * k) * plane;
        }
        return rows;
    };
    Tractions found;
    forEachPoint(patch, element, [&](const geometry::Parameters& where, double weight) {
        const CovariantPoint at(patch, element, where);
        const Matrix3d C = at.atRest(patch.section()).tangent.topLeftCorner<3, 3>();
        found.energyRoot.add(std::sqrt(weight * at.area()) * root(C, strains(at)));
    });
    for (const EdgePiece& piece : edge) {
        const CovariantPoint at(patch, element, piece.place->parameters);
        const Matrix3d C = at.atRest(patch.section()).tangent.topLeftCorner<3, 3>();
        const MatrixXd n = C * strains(at);
        const Vector2d outwards = (at.A.transpose() * at.A) * piece.place->conormal();
        MatrixXd force = MatrixXd::Zero(3, n.cols());
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) {
                force += outwards[a] * at.A.col(b) * n.row(symmetricPair(a, b));
            }
        }
        found.membrane.add(std::sqrt(piece.length) * force);
    }
    return found;
}

// By displacement along the normal, one column a function.
Tractions ofBending(const ShellPatch& patch, int element, const std::vector<EdgePiece>& edge) {
    Tractions found;
    forEachPoint(patch, element, [&](const geometry::Parameters& where, double weight) {
        const CovariantPoint at(patch, element, where);
        const Matrix3d C = at.atRest(patch.section()).tangent.bottomRightCorner<3, 3>();
        found.energyRoot.add(std::sqrt(weight * at.area()) * root(C, at.bendingRows()));
    });
    for (const EdgePiece& piece : edge) {
        const CovariantPoint at(patch, element, piece.place->parameters);
        const Matrix3d C = at.atRest(patch.section()).tangent.bottomRightCorner<3, 3>();
        const MatrixXd m = C * at.bendingRows();
        const MatrixXd derivatives[2] = {C * at.bendingDerivativeRows(0),
                                         C * at.bendingDerivativeRows(1)};
        const Eigen::Matrix2d metric = at.A.transpose() * at.A;
        const Vector2d outwards = metric * piece.place->conormal();
        const Vector2d along = metric * piece.place->tangent;
        RowVectorXd shear = RowVectorXd::Zero(m.cols()), twist = shear, moment = shear;
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) {
                const int k = symmetricPair(a, b);
                shear += outwards[a] * derivatives[b].row(k);
                twist += outwards[a] * along[b] * m.row(k);
                moment += outwards[a] * outwards[b] * m.row(k);
            }
        }
        const double weight = std::sqrt(piece.length);
        found.shear.add(weight * shear);
        found.twist.add(weight * twist);
        found.moment.add(weight * moment);
    }
    return found;
}

} // namespace

TractionBounds tractionBounds(const ShellPatch& patch, int element,
                              const std::vector<EdgePiece>& edge, const HeldMotion& held) {
    TractionBounds bounds;
    if (held.displacement) {
        const Tractions tractions = ofMembrane(patch, element, edge);
        bounds.membrane =
            largestSquare(tractions.membrane.matrix() *
                          unitMotions(patch, tractions.energyRoot.matrix(), *edge.front().place));
    }
    if (!held.bending) {
        return bounds;
    }
    const Tractions tractions = ofBending(patch, element, edge);
    const MatrixXd motions = unitMotions(patch, tractions.energyRoot.matrix(), *edge.front().place);
    Stack together;
    const auto add = [&](const Stack& rows, double& bound) {
        const MatrixXd own = rows.matrix() * motions;
        bound = largestSquare(own);
        if (bound > 0) {
            together.add(own / std::sqrt(bound));
        }
    };
    if (held.displacement) {
        add(tractions.shear, bounds.shear);
        add(tractions.twist, bounds.twist);
    }
    if (held.rotation) {
        add(tractions.moment, bounds.moment);
    }
    const double sum = together.empty() ? 0 : largestSquare(together.matrix());
    bounds.shear *= sum;
    bounds.twist *= sum;
    bounds.moment *= sum;
    return bounds;
}

} // namespace tokay::structure
