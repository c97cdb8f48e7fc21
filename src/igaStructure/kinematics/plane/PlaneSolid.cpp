// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"

#include "common/errors.hpp"
#include "igaStructure/assembly/RigidMotions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>

namespace tokay::structure {

namespace {

using ElementVector = Eigen::Matrix<double, 2, Eigen::Dynamic>;

void gather(const Eigen::VectorXd& global, const std::vector<int>& nodes, ElementVector& local) {
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        local.col(a) = global.segment<2>(2 * nodes[a]);
    }
}

void scatter(const Eigen::Ref<const ElementVector>& local, const std::vector<int>& nodes,
             Eigen::VectorXd& global) {
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        global.segment<2>(2 * nodes[a]) += local.col(a);
    }
}

// Of the displacement by the coordinates. A general product would cost more in overhead than
// in operations.
Eigen::Matrix2d gradient(const ElementVector& u, const PlaneElementTable::Gradients& gradients) {
    Eigen::Matrix2d H = Eigen::Matrix2d::Zero();
    for (int a = 0; a < u.cols(); ++a) {
        H.noalias() += u.col(a) * gradients.col(a).transpose();
    }
    return H;
}

Eigen::Matrix2d symmetric(const Eigen::Vector3d& stress) {
    Eigen::Matrix2d S;
    S << stress[0], stress[2], stress[2], stress[1];
    return S;
}

void requirePlane(const geometry::NurbsSurface& surface) {
    if (!surface.controlPoints().col(2).isZero(0)) {
        throw InputError("a plane body must lie in z = 0, but a control point has another z");
    }
}

} // namespace

// Rows of all Gauss points of an element, so that its tangent is one or two
// dense products.
struct PlaneSolid::Workspace {
    Eigen::MatrixXd strainRows;   ///< sqrt(w) R B, 3 rows a point
    Eigen::MatrixXd gradientRows; ///< gradients, 2 rows a point
    Eigen::MatrixXd stressRows;   ///< w S gradients, 2 rows a point
    Eigen::MatrixXd tangent;      ///< of the element
    Eigen::MatrixXd geometric;    ///< the same for both components

    Workspace(int nFunctions, int nPoints)
        : strainRows(3 * nPoints, 2 * nFunctions), gradientRows(2 * nPoints, nFunctions),
          stressRows(2 * nPoints, nFunctions), tangent(2 * nFunctions, 2 * nFunctions),
          geometric(nFunctions, nFunctions) {}

    void multiply(bool withGeometric) {
        tangent.noalias() = strainRows.transpose() * strainRows;
        if (!withGeometric) {
            return;
        }
        geometric.noalias() = gradientRows.transpose() * stressRows;
        for (int b = 0; b < geometric.cols(); ++b) {
            for (int a = 0; a < geometric.rows(); ++a) {
                tangent(2 * a, 2 * b) += geometric(a, b);
                tangent(2 * a + 1, 2 * b + 1) += geometric(a, b);
            }
        }
    }
};

PlaneSolid::PlaneSolid(geometry::NurbsSurface surface, const PlaneMaterial& material,
                       Strains strains, const std::vector<Support>& supports, Loads loads,
                       bool isSlit)
    : surface_(std::move(surface)),
      nodes_({surface_.u(), surface_.v()}, surface_.controlPoints(), surface_.weights(), isSlit),
      material_(material), strains_(strains), stiffness_(material.stiffness()),
      stiffnessRoot_(stiffness_.llt().matrixU()),
      fixed_(nodes_.fixed(fixedUnknowns(surface_, supports))),
      trace_(supportTrace(surface_, nodes_, supports)), u_(surface_.u(), surface_.u().degree() + 1),
      v_(surface_.v(), surface_.v().degree() + 1),
      pattern_(2, nodes_.neighbours({surface_.u(), surface_.v()})),
      external_(surface_, material, std::move(loads)) {
    requirePlane(surface_);
    for (const Support& support : supports) {
        addOwner(owners_, nodes_.fixed(fixedUnknowns(surface_, {support})),
                 static_cast<int>(supportNames_.size()));
        supportNames_.push_back(support.name);
    }
    forEachPoint(
        [this](const PlaneElement& element) {
            element.requireRegular();
            elements_.add(element);
        },
        [](const PlaneElement&) {});
}

std::vector<std::string> PlaneSolid::supportNames() const {
    return supportNames_;
}

std::vector<SupportLoad> PlaneSolid::supportLoads(const Eigen::VectorXd& displacement,
                                                  const Eigen::VectorXd& reaction,
                                                  double /*time*/) const {
    std::vector<SupportLoad> loads(supportNames_.size());
    const geometry::Points atRest =
        surface_.controlPoints()(nodes_.firstControlPoints(), Eigen::all);
    addForces(owners_, isLinear() ? atRest : moved(atRest, 2, displacement), 2, reaction, loads);
    return loads;
}

template <class Visit, class Finish>
void PlaneSolid::forEachPoint(Visit visit, Finish finish) const {
    PlaneElement element(surface_, nodes_, u_, v_);
    for (int spanV = 0; spanV < v_.nSpans(); ++spanV) {
        for (int spanU = 0; spanU < u_.nSpans(); ++spanU) {
            element.moveToElement(spanU, spanV);
            for (int point = 0; point < element.nPoints(); ++point) {
                element.moveToPoint(point);
                visit(element);
            }
            finish(element);
        }
    }
}

template <class Visit, class Finish>
void PlaneSolid::forEachStrain(const Eigen::VectorXd& displacement, Visit visit,
                               Finish finish) const {
    ElementVector u(2, elements_.nFunctions());
    for (int element = 0; element < elements_.nElements(); ++element) {
        gather(displacement, elements_.nodes(element), u);
        for (int point = 0; point < elements_.nPoints(); ++point) {
            const PlaneElementTable::Gradients gradients = elements_.gradients(element, point);
            const double volume = elements_.area(element, point) * material_.thickness;
            visit(point, gradients, volume, strain(gradient(u, gradients)));
        }
        finish(elements_.nodes(element));
    }
}

SparseMatrix PlaneSolid::massMatrix() const {
    SparseMatrix mass = pattern_.zeroMatrix();
    const int n = u_.nFunctions() * v_.nFunctions();
    Eigen::MatrixXd scalar = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    forEachPoint(
        [&](const PlaneElement& element) {
            scalar += material_.density * material_.thickness * element.area() * element.values() *
                      element.values().transpose();
        },
        [&](const PlaneElement& element) {
            for (int b = 0; b < n; ++b) {
                for (int a = 0; a < n; ++a) {
                    full(2 * a, 2 * b) = full(2 * a + 1, 2 * b + 1) = scalar(a, b);
                }
            }
            pattern_.add(element.nodes(), full, mass.valuePtr());
            scalar.setZero();
        });
    return mass;
}

const Eigen::VectorXd& PlaneSolid::externalForce(double time) {
    externalForce_ = nodes_.toNodes(external_.at(time));
    return externalForce_;
}

SparseMatrix PlaneSolid::lumpedMassMatrix() const {
    const Eigen::VectorXd rowSums = massMatrix() * Eigen::VectorXd::Ones(nUnknowns());
    return SparseMatrix(rowSums.asDiagonal());
}

PlaneSolid::Strain PlaneSolid::strain(const Eigen::Matrix2d& H) const {
    if (strains_ == Strains::linear) {
        return {{H(0, 0), H(1, 1), H(0, 1) + H(1, 0)}, Eigen::Matrix2d::Identity(), 1};
    }
    const Eigen::Matrix2d F = Eigen::Matrix2d::Identity() + H;
    // Not (F^T F - 1) / 2: that loses the digits of small strains.
    const Eigen::Matrix2d E = 0.5 * (H + H.transpose() + H.transpose() * H);
    return {{E(0, 0), E(1, 1), 2 * E(0, 1)}, F, F.determinant()};
}

StructuralModel::Internal PlaneSolid::internalForce(const Eigen::VectorXd& displacement) const {
    Internal internal{Eigen::VectorXd::Zero(nUnknowns()), 1};
    ElementVector force = ElementVector::Zero(2, elements_.nFunctions());
    forEachStrain(
        displacement,
        [&](int, const PlaneElementTable::Gradients& gradients, double volume,
            const Strain& strain) {
            const Eigen::Matrix2d firstPiola =
                volume * strain.gradient * symmetric(stiffness_ * strain.value);
            for (int a = 0; a < force.cols(); ++a) {
                force.col(a).noalias() += firstPiola * gradients.col(a);
            }
            internal.smallestVolumeRatio =
                std::min(internal.smallestVolumeRatio, strain.volumeRatio);
        },
        [&](const std::vector<int>& nodes) {
            scatter(force, nodes, internal.force);
            force.setZero();
        });
    return internal;
}

void PlaneSolid::addTangent(const PlaneElementTable::Gradients& gradients, double volume,
                            const Strain& strain, int point, Workspace& workspace) const {
    const Eigen::Matrix3d root = std::sqrt(volume) * stiffnessRoot_;
    const Eigen::Matrix2d& F = strain.gradient;
    // Variation of strain by component c of function a: (F_c1 g1, F_c2 g2,
    // F_c1 g2 + F_c2 g1), g the gradient of a; linear in g, so one matrix a component.
    Eigen::Matrix<double, 3, 2> variation[2];
    for (int c = 0; c < 2; ++c) {
        variation[c] << F(c, 0), 0, 0, F(c, 1), F(c, 1), F(c, 0);
        variation[c] = root * variation[c];
    }
    for (int a = 0; a < gradients.cols(); ++a) {
        for (int c = 0; c < 2; ++c) {
            workspace.strainRows.block<3, 1>(3 * point, 2 * a + c).noalias() =
                variation[c] * gradients.col(a);
        }
    }
    if (strains_ == Strains::nonlinear) {
        const Eigen::Matrix2d stress = volume * symmetric(stiffness_ * strain.value);
        workspace.gradientRows.middleRows<2>(2 * point) = gradients;
        workspace.stressRows.middleRows<2>(2 * point).noalias() = stress * gradients;
    }
}

StructuralModel::Internal PlaneSolid::internalForce(const Eigen::VectorXd& displacement,
                                                    SparseMatrix& tangent) const {
    if (tangent.size() == 0) {
        tangent = pattern_.zeroMatrix();
    }
    std::fill(tangent.valuePtr(), tangent.valuePtr() + tangent.nonZeros(), 0.0);
    Internal internal{Eigen::VectorXd::Zero(nUnknowns()), 1};
    Workspace workspace(elements_.nFunctions(), elements_.nPoints());
    Eigen::VectorXd strains(3 * elements_.nPoints()); // sqrt(w) R E
    forEachStrain(
        displacement,
        [&](int point, const PlaneElementTable::Gradients& gradients, double volume,
            const Strain& strain) {
            addTangent(gradients, volume, strain, point, workspace);
            strains.segment<3>(3 * point) = std::sqrt(volume) * stiffnessRoot_ * strain.value;
            internal.smallestVolumeRatio =
                std::min(internal.smallestVolumeRatio, strain.volumeRatio);
        },
        [&](const std::vector<int>& nodes) {
            workspace.multiply(strains_ == Strains::nonlinear);
            pattern_.add(nodes, workspace.tangent, tangent.valuePtr());
            const Eigen::VectorXd force = workspace.strainRows.transpose() * strains;
            scatter(Eigen::Map<const ElementVector>(force.data(), 2, elements_.nFunctions()), nodes,
                    internal.force);
        });
    return internal;
}

double PlaneSolid::strainEnergy(const Eigen::VectorXd& displacement) const {
    double energy = 0;
    forEachStrain(
        displacement,
        [&](int, const PlaneElementTable::Gradients&, double volume, const Strain& strain) {
            energy += 0.5 * volume * strain.value.dot(stiffness_ * strain.value);
        },
        [](const std::vector<int>&) {});
    return energy;
}

std::vector<std::string> PlaneSolid::freeRigidMotions() const {
    RigidMotions motions(surface_.controlPoints());
    motions.holdInPlane();
    for (int k = 0; k < surface_.nControlPoints(); ++k) {
        for (int c = 0; c < 2; ++c) {
            if (fixed_[2 * nodes_.of(k) + c]) {
                motions.holdPoint(surface_.controlPoints().row(k), Eigen::Vector3d::Unit(c));
            }
        }
    }
    return motions.freeOnes();
}

double PlaneSolid::size() const {
    const geometry::Points& points = surface_.controlPoints();
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

PlaneState PlaneSolid::stateAt(double xi, double eta, const Eigen::VectorXd& displacement) const {
    const geometry::SurfaceBasis basis = surface_.basis(xi, eta, 1);
    const int n = static_cast<int>(basis.controlPoints.size());
    ElementVector u(2, n);
    ElementVector x(2, n);
    for (int a = 0; a < n; ++a) {
        u.col(a) = displacement.segment<2>(2 * nodes_.of(basis.controlPoints[a]));
        x.col(a) = surface_.controlPoints().row(basis.controlPoints[a]).head<2>().transpose();
    }
    const Eigen::Matrix2d jacobian = basis.N.middleRows(1, 2) * x.transpose();
    const Eigen::Matrix2d H = u * (jacobian.inverse() * basis.N.middleRows(1, 2)).transpose();
    return {u * basis.N.row(0).transpose(), material_.cauchyStress(H, strains_)};
}

} // namespace tokay::structure
