// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/Solid.hpp"

#include "igaStructure/assembly/ElementTangent.hpp"
#include "igaStructure/assembly/RigidMotions.hpp"
#include "igaStructure/kinematics/solid/solidHessian.hpp"
#include "igaStructure/kinematics/solid/solidSupports.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <numeric>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3i;
using Eigen::VectorXd;

// What a thread needs beside its element.
struct Solid::Workspace {
    SolidElement::Coefficients displacement, force;
    ElementTangent tangent{3};
};

// What elements add up to. Numbers are summed row by row, so that their rounding
// does not depend on the number of threads.
struct Solid::Totals {
    Totals(int nUnknowns, int nRows)
        : force(VectorXd::Zero(nUnknowns)), energies(nRows, 0.0), smallestRatios(nRows, 1.0) {}

    double energy() const { return std::accumulate(energies.begin(), energies.end(), 0.0); }
    Internal internal() {
        return {std::move(force), *std::min_element(smallestRatios.begin(), smallestRatios.end())};
    }

    VectorXd force;
    std::vector<double> energies;
    std::vector<double> smallestRatios;
};

namespace {

std::vector<geometry::KnotVector> directions(const geometry::NurbsVolume& volume) {
    return {volume.u(), volume.v(), volume.w()};
}

} // namespace

Solid::Solid(SolidDescription description)
    : description_(std::make_unique<const SolidDescription>(std::move(description))),
      nodes_(std::make_unique<const PatchNodes>(directions(volume()), volume().controlPoints(),
                                                volume().weights(), description_->isSlit)),
      law_(material()), fixed_(nodes_->fixed(fixedUnknowns(volume(), description_->supports))),
      trace_(supportTrace(*description_, *nodes_)),
      hasSymmetricTangent_(isLinear() || pressuresHavePotential(*description_, *nodes_)),
      grid_(volume(), *nodes_), rows_(nodesOfRows()),
      pattern_(3, nodes_->neighbours(directions(volume()))),
      loading_(std::make_unique<SolidLoading>(*description_)) {
    for (std::size_t k = 0; k < description_->supports.size(); ++k) {
        addOwner(owners_, nodes_->fixed(fixedUnknowns(volume(), {description_->supports[k]})),
                 static_cast<int>(k));
    }
    forEachElement([](SolidElement& element, int, int) {
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            element.requireRegular();
        }
    });
}

std::vector<std::string> Solid::supportNames() const {
    std::vector<std::string> names;
    for (const SolidSupport& support : description_->supports) {
        names.push_back(support.name);
    }
    return names;
}

std::vector<SupportLoad> Solid::supportLoads(const VectorXd& displacement, const VectorXd& reaction,
                                             double /*time*/) const {
    std::vector<SupportLoad> loads(description_->supports.size());
    const geometry::Points atRest =
        volume().controlPoints()(nodes_->firstControlPoints(), Eigen::all);
    addForces(owners_, isLinear() ? atRest : moved(atRest, 3, displacement), 3, reaction, loads);
    return loads;
}

int Solid::nThreads() const {
    constexpr int worthAThread = 16; // elements: starting and waiting costs as much
    return nThreads_ > 0 ? nThreads_
                         : std::clamp(nElements() / worthAThread, 1, availableThreads());
}

Vector3i Solid::elementOfRow(int row, int element) const {
    const int nV = grid_.basis[1].nSpans();
    return {element, row % nV, row / nV};
}

std::vector<std::vector<int>> Solid::nodesOfRows() const {
    std::vector<std::vector<int>> nodes(grid_.basis[1].nSpans() * grid_.basis[2].nSpans());
    SolidElement element(grid_);
    for (std::size_t row = 0; row < nodes.size(); ++row) {
        std::vector<int>& own = nodes[row];
        for (int i = 0; i < grid_.basis[0].nSpans(); ++i) {
            element.moveToElement(elementOfRow(static_cast<int>(row), i));
            own.insert(own.end(), element.nodes().begin(), element.nodes().end());
        }
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
    }
    return nodes;
}

template <class Visit>
void Solid::forEachElement(Visit visit) const {
    const int nThreads = this->nThreads();
    std::vector<SolidElement> elements(nThreads, SolidElement(grid_));
    rows_.forEachRow(nThreads, [&](int row, int thread) {
        for (int i = 0; i < grid_.basis[0].nSpans(); ++i) {
            elements[thread].moveToElement(elementOfRow(row, i));
            visit(elements[thread], row, thread);
        }
    });
}

SparseMatrix Solid::massMatrix() const {
    SparseMatrix mass = pattern_.zeroMatrix();
    forEachElement([&](SolidElement& element, int, int) {
        const int n = element.nFunctions();
        Eigen::MatrixXd scalar = Eigen::MatrixXd::Zero(n, n);
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            scalar.noalias() += (material().density * element.volume() * element.values()) *
                                element.values().transpose();
        }
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * n, 3 * n);
        for (int l = 0; l < n; ++l) {
            for (int k = 0; k < n; ++k) {
                full.block<3, 3>(3 * k, 3 * l).diagonal().setConstant(scalar(k, l));
            }
        }
        pattern_.add(element.nodes(), full, mass.valuePtr());
    });
    return mass;
}

SparseMatrix Solid::lumpedMassMatrix() const {
    const VectorXd rowSums = massMatrix() * VectorXd::Ones(nUnknowns());
    return SparseMatrix(rowSums.asDiagonal());
}

Solid::PointAnswer Solid::answer(const Matrix3d& H) const {
    if (isLinear()) {
        const ElasticResponse response = law_.linearResponse(0.5 * (H + H.transpose()));
        return {symmetricOfStress(response.stress), response, Matrix3d::Identity(), 1};
    }
    const Matrix3d F = Matrix3d::Identity() + H;
    // Not (F^T F - 1) / 2: that loses the digits of small strains.
    const ElasticResponse response = law_.response(0.5 * (H + H.transpose() + H.transpose() * H));
    return {F * symmetricOfStress(response.stress), response, F, F.determinant()};
}

void Solid::addPoint(const SolidElement& element, int row, bool withTangent, Workspace& workspace,
                     Totals& totals) const {
    const SolidElement::Gradients& gradients = element.gradients();
    const PointAnswer at = answer(workspace.displacement * gradients.transpose());
    workspace.force.noalias() += (element.volume() * at.firstPiola) * gradients;
    if (withTangent) {
        const Matrix9d hessian =
            element.volume() *
            solidHessian(at.gradient, at.response,
                         isLinear() ? Matrix3d::Zero() : symmetricOfStress(at.response.stress));
        workspace.tangent.add(gradients.data(), gradients.cols(), hessian);
    }
    totals.energies[row] += element.volume() * at.response.energy;
    totals.smallestRatios[row] = std::min(totals.smallestRatios[row], at.volumeRatio);
}

void Solid::visitElement(SolidElement& element, int row, const VectorXd& displacement,
                         SparseMatrix* tangent, Workspace& workspace, Totals& totals) const {
    element.gather(displacement, workspace.displacement);
    workspace.force.setZero(3, element.nFunctions());
    if (tangent) {
        workspace.tangent.start(element.nFunctions());
    }
    for (int point = 0; point < element.nPoints(); ++point) {
        element.moveToPoint(point);
        addPoint(element, row, tangent != nullptr, workspace, totals);
    }
    element.scatter(workspace.force, totals.force);
    if (tangent) {
        pattern_.add(element.nodes(), workspace.tangent.finish(), tangent->valuePtr());
    }
}

void Solid::evaluate(const VectorXd& displacement, SparseMatrix* tangent, Totals& totals) const {
    if (tangent) {
        if (tangent->size() == 0) {
            *tangent = pattern_.zeroMatrix();
        }
        std::fill(tangent->valuePtr(), tangent->valuePtr() + tangent->nonZeros(), 0.0);
    }
    std::vector<Workspace> workspaces(nThreads());
    forEachElement([&](SolidElement& element, int row, int thread) {
        visitElement(element, row, displacement, tangent, workspaces[thread], totals);
    });
}

StructuralModel::Internal Solid::internalForce(const VectorXd& displacement) const {
    Totals totals(nUnknowns(), rows_.nRows());
    evaluate(displacement, nullptr, totals);
    return totals.internal();
}

StructuralModel::Internal Solid::internalForce(const VectorXd& displacement,
                                               SparseMatrix& tangent) const {
    Totals totals(nUnknowns(), rows_.nRows());
    evaluate(displacement, &tangent, totals);
    return totals.internal();
}

double Solid::strainEnergy(const VectorXd& displacement) const {
    Totals totals(nUnknowns(), rows_.nRows());
    evaluate(displacement, nullptr, totals);
    return totals.energy();
}

const VectorXd& Solid::externalForce(double time) {
    externalForce_ = nodes_->toNodes(loading_->deadForce(time));
    if (isLinear()) {
        addPressure(VectorXd::Zero(nUnknowns()), time, externalForce_);
    }
    return externalForce_;
}

void Solid::addFollowerForce(const VectorXd& displacement, double time, VectorXd& force) const {
    if (!isLinear()) {
        addPressure(displacement, time, force);
    }
}

void Solid::addPressure(const VectorXd& displacement, double time, VectorXd& force) const {
    force += nodes_->toNodes(loading_->pressure(nodes_->toControlPoints(displacement), time));
}

void Solid::subtractFollowerDerivative(const VectorXd& displacement, double time,
                                       SparseMatrix& tangent) const {
    if (!isLinear()) {
        loading_->subtractPressureDerivative(nodes_->toControlPoints(displacement), time, *nodes_,
                                             pattern_, tangent.valuePtr());
    }
}

std::vector<std::string> Solid::freeRigidMotions() const {
    RigidMotions motions(volume().controlPoints());
    for (int k = 0; k < nodes_->nControlPoints(); ++k) {
        for (int c = 0; c < 3; ++c) {
            if (fixed_[3 * nodes_->of(k) + c]) {
                motions.holdPoint(volume().controlPoints().row(k), Vector3d::Unit(c));
            }
        }
    }
    return motions.freeOnes();
}

double Solid::size() const {
    const geometry::Points& points = volume().controlPoints();
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

double Solid::mass() const {
    double sum = 0;
    SolidElement element(grid_);
    for (int row = 0; row < rows_.nRows(); ++row) {
        for (int i = 0; i < grid_.basis[0].nSpans(); ++i) {
            element.moveToElement(elementOfRow(row, i));
            for (int point = 0; point < element.nPoints(); ++point) {
                element.moveToPoint(point);
                sum += material().density * element.volume();
            }
        }
    }
    return sum;
}

SolidState Solid::stateAt(const Vector3d& parameters, const VectorXd& displacement) const {
    const geometry::VolumeBasis basis = volume().basis(parameters);
    const auto n = static_cast<Eigen::Index>(basis.controlPoints.size());
    SolidElement::Coefficients u(3, n);
    SolidElement::Coefficients x(3, n);
    for (Eigen::Index a = 0; a < n; ++a) {
        u.col(a) = displacement.segment<3>(3 * nodes_->of(basis.controlPoints[a]));
        x.col(a) = volume().controlPoints().row(basis.controlPoints[a]).transpose();
    }
    const Matrix3d jacobian = basis.N.bottomRows<3>() * x.transpose();
    const Matrix3d H = u * (jacobian.inverse() * basis.N.bottomRows<3>()).transpose();
    const PointAnswer at = answer(H);
    const Matrix3d stress = at.firstPiola * at.gradient.transpose() / at.volumeRatio;
    return {u * basis.N.row(0).transpose(), stress};
}

} // namespace tokay::structure
