// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/Shell.hpp"

#include "common/errors.hpp"
#include "igaStructure/assembly/ElementTangent.hpp"
#include "igaStructure/kinematics/shell/ShellParts.hpp"
#include "igaStructure/kinematics/shell/element/MembraneSection.hpp"
#include "igaStructure/kinematics/shell/element/NeoHookeanSection.hpp"
#include "igaStructure/kinematics/shell/loads/followerPotential.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace tokay::structure {

using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

std::shared_ptr<const ShellSection> makeSection(MaterialLaw law, const ShellMaterial& material,
                                                double thickness) {
    if (law == MaterialLaw::stVenantKirchhoff) {
        return std::make_shared<LinearSection>(material, thickness);
    }
    return std::make_shared<NeoHookeanSection>(material.mu(), material.lambda(), thickness);
}

} // namespace

// What a thread needs beside its element.
struct Shell::Workspace {
    explicit Workspace(bool bending) : tangent(bending ? 5 : 2) {}

    ShellElement::Coefficients displacement, linearisedAt, force;
    ElementTangent tangent;
};

// What is evaluated: forces, and if wanted their tangent, with the stresses of the mixed
// integration point method if there is a displacement at which it was linearised.
struct Shell::Evaluation {
    const VectorXd& displacement;
    SparseMatrix* tangent = nullptr;
    const VectorXd* linearisedAt = nullptr;
};

// What elements add up to. Numbers are summed row by row, so that their rounding
// does not depend on the number of threads.
struct Shell::Totals {
    VectorXd force;
    std::vector<double> energies;
    std::vector<double> smallestRatios;
};

Shell::Shell(ShellDescription description)
    : description_(std::move(description)), nodes_(description_.model),
      hasSymmetricTangent_(isLinear() || followersHavePotential(description_)) {
    if (description_.thickness.size() != description_.model.faces().size()) {
        throw InputError(fmt::format("there are {} thicknesses for {} faces: give each face one",
                                     description_.thickness.size(),
                                     description_.model.faces().size()));
    }
    if (!description_.faceMaterial.empty() &&
        description_.faceMaterial.size() != description_.model.faces().size()) {
        throw InputError(fmt::format("there are {} materials for {} faces: give each face one",
                                     description_.faceMaterial.size(),
                                     description_.model.faces().size()));
    }
    if (!description_.bending && !description_.loads.edgeMoments.empty()) {
        throw InputError("a membrane has no stiffness against a moment: take kinematics shell");
    }
    buildPatches();
    sweep_ = std::make_unique<ElementRows>(patches_);
    supports_ = std::make_unique<ShellSupports>(description_, patches_, nodes_);
    buildPattern();
    deadLoads_ = std::make_unique<DeadLoads>(description_.loads, description_.model, patches_,
                                             *sweep_, nUnknowns());
    followerLoads_ =
        std::make_unique<FollowerLoads>(description_.loads, description_.model, patches_, *sweep_);
}

int Shell::nThreads() const {
    constexpr int worthAThread = 64; // elements: starting and waiting costs as much
    int nElements = 0;
    for (const auto& patch : patches_) {
        nElements += patch->patch().nElements();
    }
    return nThreads_ > 0 ? nThreads_ : std::clamp(nElements / worthAThread, 1, availableThreads());
}

void Shell::buildPatches() {
    for (std::size_t face = 0; face < description_.thickness.size(); ++face) {
        const ShellMaterial& material = description_.materialOf(static_cast<int>(face));
        const double thickness = description_.thickness[face];
        const geometry::TrimmedPatch& patch = description_.model.patch(static_cast<int>(face));
        const int least = description_.bending ? 2 : 1;
        if (std::min(patch.basis().u().degree(), patch.basis().v().degree()) < least) {
            throw InputError(fmt::format("patch \"{}\" has degree 1, but bending needs degree 2 "
                                         "at least in both directions",
                                         patch.name()));
        }
        std::shared_ptr<const ShellSection> section =
            makeSection(description_.material.law, material, thickness);
        if (!description_.bending) {
            section =
                std::make_shared<MembraneSection>(section, thickness * description_.prestress);
        }
        patches_.push_back(std::make_unique<ShellPatch>(patch, nodes_.ofFace[face], section,
                                                        material.density * thickness,
                                                        description_.cutRule));
    }
}

void Shell::buildPattern() {
    std::vector<std::vector<int>> neighbours(nodes_.count());
    // Repetitions are removed each time that a list is full.
    const auto connect = [&](const std::vector<int>& nodes) {
        for (int node : nodes) {
            std::vector<int>& own = neighbours[node];
            if (own.size() + nodes.size() > own.capacity()) {
                std::sort(own.begin(), own.end());
                own.erase(std::unique(own.begin(), own.end()), own.end());
                own.reserve(2 * (own.size() + nodes.size()));
            }
            own.insert(own.end(), nodes.begin(), nodes.end());
        }
    };
    ShellElement element;
    for (const auto& patch : patches_) {
        for (int number = 0; number < patch->patch().nElements(); ++number) {
            element.moveTo(*patch, number % patch->u().nSpans(), number / patch->u().nSpans());
            if (element.nPoints() > 0) {
                connect(element.nodes());
            }
        }
    }
    for (const auto& coupling : constraints().couplings) {
        connect(coupling->nodes());
    }
    pattern_ = std::make_unique<NodePattern>(3, std::move(neighbours));
}

SparseMatrix Shell::massMatrix() const {
    SparseMatrix mass = pattern_->zeroMatrix();
    sweep_->forEachElement(nThreads(), [&](ShellElement& element, int, int) {
        const int n = element.nFunctions();
        Eigen::MatrixXd scalar = Eigen::MatrixXd::Zero(n, n);
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const Eigen::Map<const VectorXd> N(element.functions().row(0), n);
            scalar += element.patch().massPerArea() * element.area() * N * N.transpose();
        }
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * n, 3 * n);
        for (int l = 0; l < n; ++l) {
            for (int k = 0; k < n; ++k) {
                full.block<3, 3>(3 * k, 3 * l).diagonal().setConstant(scalar(k, l));
            }
        }
        pattern_->add(element.nodes(), full, mass.valuePtr());
    });
    return mass;
}

SparseMatrix Shell::lumpedMassMatrix() const {
    const VectorXd rowSums = massMatrix() * VectorXd::Ones(nUnknowns());
    return SparseMatrix(rowSums.asDiagonal());
}

// Stress resultants, forces and stiffness of a point.
struct Shell::PointAnswer {
    SurfaceDerivatives force;
    ShellHessian stiffness;
    double energy;
    double volumeRatio = 1;
};

Shell::PointAnswer Shell::linearAnswer(const ShellElement& element,
                                       const SurfaceDerivatives& displacement) const {
    const SurfacePoint& reference = element.reference();
    const SectionResponse rest =
        element.patch().section().response(reference.forms(), Vector6d::Zero());
    PointAnswer answer;
    answer.stiffness = shellStiffness(reference, rest.tangent, rest.resultants);
    const Eigen::Map<const Eigen::Matrix<double, 15, 1>> u(displacement.data());
    Eigen::Map<Eigen::Matrix<double, 15, 1>>(answer.force.data()) = answer.stiffness * u;
    answer.energy = 0.5 * displacement.cwiseProduct(answer.force).sum();
    return answer;
}

namespace {

// Strains that the linearisation at one displacement predicts at another.
Vector6d predictedStrain(const SurfacePoint& reference, const SurfaceDerivatives& linearisedAt,
                         const SurfaceDerivatives& displacement) {
    return shellStrain(reference, linearisedAt, Strains::nonlinear) +
           shellStrain(SurfacePoint(reference.derivatives + linearisedAt),
                       displacement - linearisedAt, Strains::linear);
}

} // namespace

Shell::PointAnswer Shell::nonlinearAnswer(const ShellElement& element,
                                          const SurfaceDerivatives& displacement,
                                          const SurfaceDerivatives* linearisedAt,
                                          bool withStiffness) const {
    const SurfacePoint& reference = element.reference();
    const SurfacePoint current(reference.derivatives + displacement);
    const Vector6d strain = shellStrain(reference, displacement, Strains::nonlinear);
    const SectionResponse response = element.patch().section().response(reference.forms(), strain);
    PointAnswer answer;
    answer.force = shellForce(current, response.resultants);
    if (withStiffness) {
        Vector6d resultants = response.resultants;
        if (linearisedAt) {
            resultants += response.tangent *
                          (predictedStrain(reference, *linearisedAt, displacement) - strain);
        }
        answer.stiffness = shellStiffness(current, response.tangent, resultants);
    }
    answer.energy = response.energy;
    answer.volumeRatio = current.normal.area() / reference.normal.area();
    return answer;
}

void Shell::visitElement(ShellElement& element, int row, const Evaluation& evaluation,
                         Workspace& workspace, Totals& totals) const {
    const int n = element.nFunctions();
    SparseMatrix* const tangent = evaluation.tangent;
    element.gather(evaluation.displacement, workspace.displacement);
    if (evaluation.linearisedAt) {
        element.gather(*evaluation.linearisedAt, workspace.linearisedAt);
    }
    workspace.force.setZero(3, n);
    if (tangent) {
        workspace.tangent.start(n);
    }
    for (int point = 0; point < element.nPoints(); ++point) {
        element.moveToPoint(point);
        const SurfaceDerivatives u = element.functions().derivatives(workspace.displacement);
        PointAnswer answer = isLinear() ? linearAnswer(element, u) : [&] {
            if (!evaluation.linearisedAt) {
                return nonlinearAnswer(element, u, nullptr, tangent);
            }
            const SurfaceDerivatives at = element.functions().derivatives(workspace.linearisedAt);
            return nonlinearAnswer(element, u, &at, tangent);
        }();
        element.functions().addTransposed(element.area() * answer.force, workspace.force);
        if (tangent) {
            answer.stiffness *= element.area();
            const SurfaceFunctions& functions = element.functions();
            const int size = 3 * workspace.tangent.nVectors();
            workspace.tangent.add(functions.row(1), functions.row(2) - functions.row(1),
                                  answer.stiffness.topLeftCorner(size, size));
        }
        totals.energies[row] += element.area() * answer.energy;
        totals.smallestRatios[row] = std::min(totals.smallestRatios[row], answer.volumeRatio);
    }
    element.scatter(workspace.force, totals.force);
    if (tangent) {
        pattern_->add(element.nodes(), workspace.tangent.finish(), tangent->valuePtr());
    }
}

void Shell::addCouplings(const VectorXd& displacement, SparseMatrix* tangent, VectorXd& force,
                         double& energy) const {
    for (const auto& coupling : constraints().couplings) {
        const EdgeCoupling::Answer answer =
            coupling->answer(displacement, description_.strains, tangent);
        for (std::size_t k = 0; k < coupling->nodes().size(); ++k) {
            force.segment<3>(3 * coupling->nodes()[k]) +=
                answer.force.segment<3>(3 * static_cast<Eigen::Index>(k));
        }
        if (tangent) {
            pattern_->add(coupling->nodes(), answer.tangent, tangent->valuePtr());
        }
        energy += answer.energy;
    }
}

StructuralModel::Internal Shell::evaluate(const Evaluation& evaluation, double& energy) const {
    SparseMatrix* const tangent = evaluation.tangent;
    if (tangent) {
        if (tangent->size() == 0) {
            *tangent = pattern_->zeroMatrix();
        }
        std::fill(tangent->valuePtr(), tangent->valuePtr() + tangent->nonZeros(), 0.0);
    }
    std::vector<Workspace> workspaces(nThreads(), Workspace(description_.bending));
    Totals totals{VectorXd::Zero(nUnknowns()), std::vector<double>(sweep_->nRows(), 0.0),
                  std::vector<double>(sweep_->nRows(), 1.0)};
    sweep_->forEachElement(nThreads(), [&](ShellElement& element, int thread, int row) {
        visitElement(element, row, evaluation, workspaces[thread], totals);
    });
    energy = std::accumulate(totals.energies.begin(), totals.energies.end(), 0.0);
    addCouplings(evaluation.displacement, tangent, totals.force, energy);
    return {std::move(totals.force),
            *std::min_element(totals.smallestRatios.begin(), totals.smallestRatios.end())};
}

StructuralModel::Internal Shell::internalForce(const VectorXd& displacement) const {
    double energy = 0;
    return evaluate({displacement}, energy);
}

StructuralModel::Internal Shell::internalForce(const VectorXd& displacement,
                                               SparseMatrix& tangent) const {
    double energy = 0;
    return evaluate({displacement, &tangent}, energy);
}

StructuralModel::Internal Shell::mixedInternalForce(const VectorXd& displacement,
                                                    const VectorXd& linearisedAt,
                                                    SparseMatrix& tangent) const {
    double energy = 0;
    return evaluate({displacement, &tangent, &linearisedAt}, energy);
}

double Shell::strainEnergy(const VectorXd& displacement) const {
    double energy = 0;
    evaluate({displacement}, energy);
    return energy;
}

const VectorXd& Shell::externalForce(double time) {
    externalForce_ = deadLoads_->at(time);
    if (isLinear()) {
        followerLoads_->addForce(VectorXd::Zero(nUnknowns()), time, externalForce_);
    }
    return externalForce_;
}

void Shell::addFollowerForce(const VectorXd& displacement, double time, VectorXd& force) const {
    if (!isLinear()) {
        followerLoads_->addForce(displacement, time, force);
    }
}

void Shell::subtractFollowerDerivative(const VectorXd& displacement, double time,
                                       SparseMatrix& tangent) const {
    if (!isLinear()) {
        followerLoads_->subtractDerivative(displacement, time, *pattern_, tangent.valuePtr());
    }
}

std::vector<std::string> Shell::freeRigidMotions() const {
    return structure::freeRigidMotions(description_, nodes_, constraints());
}

std::vector<std::string> Shell::looseParts() const {
    return structure::looseParts(description_, nodes_, constraints());
}

namespace {

// Physical components of contravariant resultants in the frame along a1.
Vector3d inFrame(const SurfacePoint& point, const Vector3d& contravariantComponents) {
    const Vector3d a1 = point.derivatives.col(0);
    const Vector3d a2 = point.derivatives.col(1);
    const Vector3d e1 = a1.normalized();
    const Vector3d e2 = point.normal.value().cross(e1);
    Eigen::Matrix2d along;
    along << a1.dot(e1), a2.dot(e1), a1.dot(e2), a2.dot(e2);
    Eigen::Matrix2d n;
    n << contravariantComponents[0], contravariantComponents[2], contravariantComponents[2],
        contravariantComponents[1];
    const Eigen::Matrix2d components = along * n * along.transpose();
    return {components(0, 0), components(1, 1), components(0, 1)};
}

} // namespace

ShellElement Shell::elementAt(int face, const geometry::Parameters& at) const {
    const ShellPatch& patch = *patches_[face];
    const int number = patch.patch().elementAt(at);
    ShellElement element;
    element.moveTo(patch, number % patch.u().nSpans(), number / patch.u().nSpans());
    element.moveToPlace(at);
    return element;
}

Vector3d Shell::displacementAt(int face, const geometry::Parameters& at, double zeta,
                               const VectorXd& displacement) const {
    const ShellElement element = elementAt(face, at);
    ShellElement::Coefficients u;
    element.gather(displacement, u);
    Vector3d value = element.functions().value(u);
    if (zeta != 0) {
        value += zeta * normalChange(element.reference(), element.functions().derivatives(u),
                                     description_.strains);
    }
    return value;
}

Eigen::Matrix2d Shell::planeGradientAt(int face, const geometry::Parameters& at,
                                       const VectorXd& displacement) const {
    const PatchLocation place(*patches_[face], at, Eigen::Vector2d::Zero());
    Eigen::Matrix2d byParameters = Eigen::Matrix2d::Zero();
    for (std::size_t k = 0; k < place.nodes.size(); ++k) {
        byParameters += displacement.segment<2>(3 * place.nodes[k]) *
                        place.N.block<2, 1>(1, static_cast<Eigen::Index>(k)).transpose();
    }
    return byParameters * place.baseVectors.topRows<2>().inverse();
}

ShellState Shell::stateAt(int face, double xi, double eta, const VectorXd& displacement) const {
    const ShellElement element = elementAt(face, {xi, eta});
    ShellElement::Coefficients u;
    element.gather(displacement, u);
    const SurfacePoint& reference = element.reference();
    const SurfaceDerivatives change = element.functions().derivatives(u);
    const Vector6d resultants =
        patches_[face]
            ->section()
            .response(reference.forms(), shellStrain(reference, change, description_.strains))
            .resultants;
    const SurfacePoint current(isLinear() ? reference.derivatives : reference.derivatives + change);
    const double ratio = current.normal.area() / reference.normal.area();
    return {element.functions().value(u), inFrame(current, resultants.head<3>()) / ratio,
            inFrame(current, resultants.tail<3>()) / ratio};
}

} // namespace tokay::structure
