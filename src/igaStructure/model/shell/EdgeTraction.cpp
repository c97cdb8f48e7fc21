#include "igaStructure/model/shell/EdgeTraction.hpp"

#include "geometry/spanBasis.hpp"
#include "igaStructure/model/shell/shellStrain.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>

namespace tokay::structure {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector2d;
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

// Index of a symmetric pair among (11, 22, 12).
int pair(int a, int b) {
    return a == b ? a : 2;
}

// A surface with its Christoffel symbols and their derivatives, and what covariant
// derivatives do to a function on it.
class CovariantPoint {
  public:
    CovariantPoint(const geometry::NurbsSurface& surface, const geometry::SurfaceBasis& basis)
        : N(basis.N), X(basis.N * surface.controlPoints()(basis.controlPoints, Eigen::all)) {
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
        dualDerivative(dual);
    }

    /// N|ab for all functions.
    RowVectorXd twice(int a, int b) const {
        return N.row(second(a, b)) - christoffel[a][b][0] * N.row(1) -
               christoffel[a][b][1] * N.row(2);
    }
    /// N|abc.
    RowVectorXd thrice(int a, int b, int c) const {
        RowVectorXd sum = N.row(third(a, b, c));
        for (int s = 0; s < 2; ++s) {
            sum -= christoffelDerivative[a][b][c][s] * N.row(1 + s) +
                   christoffel[a][b][s] * N.row(second(s, c)) + christoffel[a][c][s] * twice(s, b) +
                   christoffel[b][c][s] * twice(a, s);
        }
        return sum;
    }
    /// Derivative of the unit normal.
    Vector3d normalDerivative(int a) const { return -A * mixed.col(a); }

    MatrixXd N;
    MatrixXd X; ///< rows as of N
    Eigen::Matrix<double, 3, 2> A;
    Vector3d A3;
    Matrix2d inverse;   ///< of the metric
    Matrix2d curvature; ///< b_ab
    Matrix2d mixed;     ///< b^c_a: row c, column a

  private:
    void dualDerivative(const Eigen::Matrix<double, 3, 2>& dual) {
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

    Vector2d christoffel[2][2];
    Vector2d christoffelDerivative[2][2][2];
};

// Rows of a vector: each function times each component.
MatrixXd times(const RowVectorXd& functions, const Vector3d& vector) {
    MatrixXd row(1, 3 * functions.size());
    for (Eigen::Index k = 0; k < functions.size(); ++k) {
        row.middleCols<3>(3 * k) = functions[k] * vector.transpose();
    }
    return row;
}

constexpr std::array<std::array<int, 2>, 3> pairs = {{{0, 0}, {1, 1}, {0, 1}}};

// (E11, E22, 2 E12), linear.
MatrixXd membraneRows(const CovariantPoint& at) {
    MatrixXd rows(3, 3 * at.N.cols());
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = pairs[k];
        rows.row(k) = times(at.N.row(1 + a), at.A.col(b));
        if (a != b) {
            rows.row(k) += times(at.N.row(1 + b), at.A.col(a));
        }
    }
    return rows;
}

// (k11, k22, 2 k12) = -(N|ab . A3), linear.
MatrixXd curvatureRows(const CovariantPoint& at) {
    MatrixXd rows(3, 3 * at.N.cols());
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = pairs[k];
        rows.row(k) = -(a == b ? 1 : 2) * times(at.twice(a, b), at.A3);
    }
    return rows;
}

// Their covariant derivative by c.
MatrixXd curvatureDerivativeRows(const CovariantPoint& at, int c) {
    MatrixXd rows(3, 3 * at.N.cols());
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = pairs[k];
        rows.row(k) = -(a == b ? 1 : 2) * (times(at.thrice(a, b, c), at.A3) +
                                           times(at.twice(a, b), at.normalDerivative(c)));
    }
    return rows;
}

} // namespace

EdgeTraction::EdgeTraction(const PatchPlace& place, int element, bool bending) {
    const ShellPatch& patch = *place.patch;
    const geometry::NurbsSurface& surface = patch.surface();
    const int nU = patch.patch().nElementsU();
    const int spanU = surface.u().findSpan(surface.u().breakpoints()[element % nU]);
    const int spanV = surface.v().findSpan(surface.v().breakpoints()[element / nU]);
    const geometry::SurfaceBasis basis =
        geometry::spanBasis(surface, spanU, spanV, place.parameters[0], place.parameters[1], 3);
    for (const int k : basis.controlPoints) {
        nodes.push_back(patch.nodes()[k]);
    }
    // The geometry is that of the place; the sliver's own is the same surface.
    const CovariantPoint at(surface, basis);
    const Vector2d outwards = (at.A.transpose() * at.A) * place.conormal();
    SurfaceDerivatives position;
    position = at.X.middleRows(1, 5).transpose();
    const SectionResponse rest =
        patch.section().response(SurfacePoint(position).forms(), Vector6d::Zero());

    const MatrixXd n = rest.tangent.topLeftCorner<3, 3>() * membraneRows(at);
    force = MatrixXd::Zero(3, n.cols());
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
            force += outwards[a] * at.A.col(b) * n.row(pair(a, b));
            for (int i = 0; i < 3; ++i) {
                force.row(i) += outwards[a] * rest.resultants[pair(a, b)] *
                                times(at.N.row(1 + b), Vector3d::Unit(i));
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
            const auto row = m.row(pair(a, b));
            force += outwards[a] * at.normalDerivative(b) * row;
            force += outwards[a] * at.A3 * derivatives[b].row(pair(a, b));
            moment += outwards[a] * outwards[b] * row;
            twisting += outwards[a] * along[b] * row;
        }
    }
    twist = -at.A3 * twisting;
}

} // namespace tokay::structure
