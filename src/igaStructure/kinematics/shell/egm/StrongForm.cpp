// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/StrongForm.hpp"

#include "igaStructure/kinematics/shell/egm/FaceJump.hpp"
#include "igaStructure/kinematics/shell/egm/TaylorPolynomial.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace tokay::structure {

using Eigen::Vector3d;

namespace {

using Index = std::pair<int, int>; // number of derivatives by xi and by eta

Index raised(const Index& index, int axis) {
    return axis == 0 ? Index{index.first + 1, index.second} : Index{index.first, index.second + 1};
}

// A number that is linear in the derivatives of a displacement: the sum of
// coefficient . derivative, the coefficients being functions of (xi, eta).
class Functional {
  public:
    static Functional derivative(const Index& index, const TaylorVector& coefficient) {
        Functional functional;
        functional.terms_[index] = coefficient;
        return functional;
    }

    void add(const TaylorPolynomial& factor, const Functional& other) {
        for (const auto& [index, coefficient] : other.terms_) {
            for (int c = 0; c < 3; ++c) {
                terms_[index][c] += factor * coefficient[c];
            }
        }
    }

    Functional by(int axis) const {
        Functional result;
        for (const auto& [index, coefficient] : terms_) {
            for (int c = 0; c < 3; ++c) {
                result.terms_[index][c] += coefficient[c].derivative(axis);
                result.terms_[raised(index, axis)][c] += coefficient[c];
            }
        }
        return result;
    }

    // Its row for the functions, three columns each.
    Eigen::RowVectorXd row(const Eigen::MatrixXd& N) const {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(3 * N.cols());
        for (const auto& [index, coefficient] : terms_) {
            const auto derivative = N.row(geometry::derivativeRow(index.first, index.second));
            for (Eigen::Index k = 0; k < N.cols(); ++k) {
                for (int c = 0; c < 3; ++c) {
                    row[3 * k + c] += coefficient[c].value() * derivative[k];
                }
            }
        }
        return row;
    }

  private:
    std::map<Index, TaylorVector> terms_;
};

// Three functionals: a vector of space.
using VectorFunctional = std::array<Functional, 3>;

constexpr Index first[2] = {{1, 0}, {0, 1}};
constexpr Index second[2][2] = {{{2, 0}, {1, 1}}, {{1, 1}, {0, 2}}};

// The surface around a point: base vectors, normal, metric.
struct Surface {
    explicit Surface(const geometry::Points& derivatives) {
        TaylorVector X;
        for (int c = 0; c < 3; ++c) {
            X[c] = TaylorPolynomial::of(derivatives.col(c));
        }
        for (int a = 0; a < 2; ++a) {
            for (int c = 0; c < 3; ++c) {
                A[a][c] = X[c].derivative(a);
            }
        }
        const TaylorVector across = cross(A[0], A[1]);
        const TaylorPolynomial square = dot(across, across);
        area = square.power(0.5);
        A3 = square.power(-0.5) * across;
        const TaylorPolynomial inverseSquare = square.power(-1);
        metric = {dot(A[0], A[0]), dot(A[1], A[1]), dot(A[0], A[1])};
        inverse[0][0] = inverseSquare * metric[1];
        inverse[1][1] = inverseSquare * metric[0];
        inverse[0][1] = inverse[1][0] = TaylorPolynomial(-1) * (inverseSquare * metric[2]);
    }

    // Christoffel symbols of the second kind, [c] of a pair (a, b).
    std::array<TaylorPolynomial, 2> christoffel(int a, int b) const {
        TaylorVector Aab;
        for (int c = 0; c < 3; ++c) {
            Aab[c] = A[a][c].derivative(b);
        }
        const TaylorPolynomial lower[2] = {dot(Aab, A[0]), dot(Aab, A[1])};
        return {inverse[0][0] * lower[0] + inverse[0][1] * lower[1],
                inverse[1][0] * lower[0] + inverse[1][1] * lower[1]};
    }

    // Plane stress over E / (1 - nu^2).
    TaylorPolynomial elasticity(double nu, int a, int b, int c, int d) const {
        const auto& G = inverse;
        return TaylorPolynomial(nu) * (G[a][b] * G[c][d]) +
               TaylorPolynomial(0.5 * (1 - nu)) * (G[a][c] * G[b][d] + G[a][d] * G[b][c]);
    }

    // Contravariant components of a stress (11, 22, 12) in the frame along A1.
    std::array<std::array<TaylorPolynomial, 2>, 2> contravariant(const Vector3d& stress) const {
        const TaylorPolynomial length = metric[0].power(-0.5); // 1 / |A1|
        const TaylorPolynomial height = area.power(-1) * metric[0].power(0.5);
        // Rows: A^1, A^2 in the frame.
        const TaylorPolynomial dual[2][2] = {
            {length, TaylorPolynomial(-1) * (metric[2] * length * length * height)}, {0, height}};
        const double sigma[2][2] = {{stress[0], stress[2]}, {stress[2], stress[1]}};
        std::array<std::array<TaylorPolynomial, 2>, 2> result;
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) {
                for (int k = 0; k < 2; ++k) {
                    for (int l = 0; l < 2; ++l) {
                        result[a][b] += TaylorPolynomial(sigma[k][l]) * (dual[a][k] * dual[b][l]);
                    }
                }
            }
        }
        return result;
    }

    std::array<TaylorVector, 2> A;
    TaylorVector A3;
    TaylorPolynomial area;
    std::array<TaylorPolynomial, 3> metric; // 11, 22, 12
    TaylorPolynomial inverse[2][2];
};

// A resultant's components by those of a strain: stiffness C^abcd strain_cd.
Functional resultant(const Surface& surface, double stiffness, double nu, int a, int b,
                     const Functional (&strain)[2][2]) {
    Functional sum;
    for (int c = 0; c < 2; ++c) {
        for (int d = 0; d < 2; ++d) {
            sum.add(TaylorPolynomial(stiffness) * surface.elasticity(nu, a, b, c, d), strain[c][d]);
        }
    }
    return sum;
}

void addMembrane(const Surface& surface, double stiffness, double nu, VectorFunctional& L) {
    Functional strain[2][2];
    for (int c = 0; c < 2; ++c) {
        for (int d = 0; d < 2; ++d) {
            strain[c][d].add(0.5, Functional::derivative(first[c], surface.A[d]));
            strain[c][d].add(0.5, Functional::derivative(first[d], surface.A[c]));
        }
    }
    for (int a = 0; a < 2; ++a) {
        VectorFunctional flux;
        for (int b = 0; b < 2; ++b) {
            const Functional n = resultant(surface, stiffness, nu, a, b, strain);
            for (int i = 0; i < 3; ++i) {
                flux[i].add(surface.area * surface.A[b][i], n);
            }
        }
        for (int i = 0; i < 3; ++i) {
            L[i].add(1, flux[i].by(a));
        }
    }
}

void addPrestress(const Surface& surface, const Vector3d& prestress, VectorFunctional& L) {
    const auto S = surface.contravariant(prestress);
    for (int i = 0; i < 3; ++i) {
        TaylorVector along{};
        along[i] = 1;
        for (int a = 0; a < 2; ++a) {
            Functional flux;
            for (int b = 0; b < 2; ++b) {
                flux.add(surface.area * S[a][b], Functional::derivative(first[b], along));
            }
            L[i].add(1, flux.by(a));
        }
    }
}

// Weakly the work of moments is that of m^ab on -(v,ab - Gamma^c_ab v,c) . A3.
void addBending(const Surface& surface, double stiffness, double nu, VectorFunctional& L) {
    std::array<TaylorPolynomial, 2> symbols[2][2];
    Functional curvature[2][2];
    for (int c = 0; c < 2; ++c) {
        for (int d = 0; d < 2; ++d) {
            symbols[c][d] = surface.christoffel(c, d);
            curvature[c][d].add(-1, Functional::derivative(second[c][d], surface.A3));
            for (int e = 0; e < 2; ++e) {
                curvature[c][d].add(symbols[c][d][e], Functional::derivative(first[e], surface.A3));
            }
        }
    }
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
            const Functional m = resultant(surface, stiffness, nu, a, b, curvature);
            for (int i = 0; i < 3; ++i) {
                Functional moment;
                moment.add(surface.area * surface.A3[i], m);
                L[i].add(1, moment.by(a).by(b));
                for (int c = 0; c < 2; ++c) {
                    Functional turned;
                    turned.add(symbols[a][b][c], moment);
                    L[i].add(1, turned.by(c));
                }
            }
        }
    }
}

geometry::SurfaceBasis basisOf(const ShellPatch& patch, int element,
                               const geometry::Parameters& at) {
    const geometry::NurbsSurface& surface = patch.surface();
    const int nU = patch.patch().nElementsU();
    return geometry::spanBasis(surface,
                               surface.u().findSpan(surface.u().breakpoints()[element % nU]),
                               surface.v().findSpan(surface.v().breakpoints()[element / nU]), at[0],
                               at[1], TaylorPolynomial::degree);
}

// What knots add to the fourth derivative along an axis, if it has degree 3.
Eigen::RowVectorXd knotPart(const ShellPatch& patch, int element, const geometry::Parameters& at,
                            int axis, NodeUnion& nodes) {
    Eigen::RowVectorXd part = Eigen::RowVectorXd::Zero(nodes.size());
    if (!hasFourthDerivativeInKnots(patch.surface(), axis)) {
        return part;
    }
    const auto [before, after] = neighboursAlong(patch.patch(), element, axis);
    std::optional<FaceJump> lower, upper;
    if (before >= 0) {
        lower.emplace(patch, axis, std::array<int, 2>{before, element});
    }
    if (after >= 0) {
        upper.emplace(patch, axis, std::array<int, 2>{element, after});
    }
    const bool hasLower = lower && lower->isSmooth(), hasUpper = upper && upper->isSmooth();
    const geometry::ParameterBox box = patch.patch().elementBox(element);
    const double place = (at[axis] - box.lower[axis]) / box.size()[axis];
    if (hasLower) {
        lower->add(at, 3, (hasUpper ? 1 - place : 1) / lower->size(), nodes, part);
    }
    if (hasUpper) {
        upper->add(at, 3, (hasLower ? place : 1) / upper->size(), nodes, part);
    }
    return part;
}

// Rows of derivatives of the nodes' functions: with what is in knots, for bending.
Eigen::MatrixXd spreadDerivatives(const ShellPatch& patch, int element,
                                  const geometry::Parameters& at, const Eigen::MatrixXd& N,
                                  std::vector<int>& nodes) {
    NodeUnion all;
    const std::vector<Eigen::Index> places = all.add(nodes);
    const Eigen::RowVectorXd alongXi = knotPart(patch, element, at, 0, all);
    const Eigen::RowVectorXd alongEta = knotPart(patch, element, at, 1, all);
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(N.rows(), all.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        spread.col(places[k]) += N.col(static_cast<Eigen::Index>(k));
    }
    spread.row(geometry::derivativeRow(4, 0)).head(alongXi.size()) += alongXi;
    spread.row(geometry::derivativeRow(0, 4)) += alongEta;
    nodes = all.nodes();
    return spread;
}

double squaredCurvature(const geometry::Points& X, const Vector3d& normal) {
    Eigen::Matrix2d metric, b;
    for (int a = 0; a < 2; ++a) {
        for (int c = 0; c < 2; ++c) {
            metric(a, c) = X.row(1 + a).dot(X.row(1 + c));
            const auto [k, l] = second[a][c];
            b(a, c) = X.row(geometry::derivativeRow(k, l)) * normal;
        }
    }
    const Eigen::Matrix2d mixed = metric.inverse() * b;
    return (mixed * mixed).trace();
}

} // namespace

StrongForm::StrongForm(const ShellDescription& description, int face, const ShellPatch& patch,
                       int element, const geometry::Parameters& at) {
    const geometry::SurfaceBasis basis = basisOf(patch, element, at);
    for (const int k : basis.controlPoints) {
        nodes.push_back(patch.nodes()[k]);
    }
    const geometry::Points X =
        basis.N * patch.surface().controlPoints()(basis.controlPoints, Eigen::all);
    const Surface surface(X);
    position = X.row(0).transpose();
    for (int c = 0; c < 3; ++c) {
        normal[c] = surface.A3[c].value();
    }
    area = surface.area.value();

    const ShellMaterial& material = description.materialOf(face);
    const double thickness = description.thickness[face];
    const Vector3d prestress = thickness * description.prestress;
    membrane_ = material.planeStressModulus() * thickness;
    bending_ = description.bending ? membrane_ * thickness * thickness / 12 : 0;
    tension_ = prestress.cwiseAbs().maxCoeff();
    curvature_ = std::sqrt(squaredCurvature(X, normal));

    VectorFunctional operators;
    addMembrane(surface, membrane_, material.poissonsRatio, operators);
    if (tension_ > 0) {
        addPrestress(surface, prestress, operators);
    }
    if (bending_ > 0) {
        addBending(surface, bending_, material.poissonsRatio, operators);
    }
    const Eigen::MatrixXd N =
        description.bending ? spreadDerivatives(patch, element, at, basis.N, nodes) : basis.N;
    L.resize(3, 3 * N.cols());
    for (int i = 0; i < 3; ++i) {
        L.row(i) = operators[i].row(N) / area;
    }
}

double StrongForm::tangential(double elementSize) const {
    return (membrane_ + tension_) / (elementSize * elementSize);
}

double StrongForm::across(double elementSize) const {
    constexpr double flat = 1e-6; // rise over size of an element: rounding of coordinates
    const double h2 = elementSize * elementSize;
    const double curved = curvature_ * elementSize > flat ? membrane_ * curvature_ * curvature_ : 0;
    return bending_ / (h2 * h2) + tension_ / h2 + curved;
}

} // namespace tokay::structure
