// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/edgeCoupling/MovedEdgesModel.hpp"

#include "igaStructure/assembly/RigidMotions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Control points by the number of the unknown that each component is.
VectorXd unknownsOfControlPoints(const StructuralModel& model) {
    return model.controlDisplacements(
        VectorXd::LinSpaced(model.nUnknowns(), 0, model.nUnknowns() - 1));
}

} // namespace

MovedEdgesModel::MovedEdgesModel(StructuralModel& model, const mapper::EdgeQuadrature& edge,
                                 geometry::Points controlPoints)
    : model_(model), edge_(edge), controlPoints_(std::move(controlPoints)), fixed_(model.fixed()) {
    if (model.hasDependents()) {
        throw InputError("model.edgeMethod: egm does not go with edges that another structure "
                         "moves (coupling.side: dirichlet); choose another method");
    }
    const VectorXd unknownOf = unknownsOfControlPoints(model);
    for (int c = 0; c < model.nComponents(); ++c) {
        parts_.push_back(makePart(c, unknownOf));
    }
    if (std::none_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.trace; })) {
        throw InputError("coupling.interface: supports hold these edges altogether, so that "
                         "another structure cannot move them; remove them from the supports");
    }
    makeBasis();
}

MovedEdgesModel::Part MovedEdgesModel::makePart(int component, const VectorXd& unknownOf) const {
    Part part;
    std::vector<Eigen::Index> columns;
    for (std::size_t k = 0; k < edge_.functions().size(); ++k) {
        const double unknown = unknownOf[model_.nComponents() * edge_.functions()[k] + component];
        const int number = static_cast<int>(std::lround(unknown));
        if (!model_.fixed()[static_cast<std::size_t>(number)]) {
            part.unknowns.push_back(number);
            columns.push_back(static_cast<Eigen::Index>(k));
        }
    }
    if (!columns.empty()) {
        part.trace.emplace(edge_.values()(Eigen::all, columns), edge_.weights());
        part.coefficients = VectorXd::Zero(part.trace->rank());
    }
    return part;
}

void MovedEdgesModel::makeBasis() {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<bool> isTurned(fixed_.size(), false);
    for (const Part& part : parts_) {
        if (!part.trace) {
            continue;
        }
        for (int k = 0; k < part.trace->rank(); ++k) {
            fixed_[static_cast<std::size_t>(part.unknowns[static_cast<std::size_t>(k)])] = true;
        }
        if (!part.trace->isSingular()) {
            continue;
        }
        turns_ = true;
        const MatrixXd& block = part.trace->basis();
        for (Eigen::Index i = 0; i < block.rows(); ++i) {
            const int row = part.unknowns[static_cast<std::size_t>(i)];
            isTurned[static_cast<std::size_t>(row)] = true;
            for (Eigen::Index j = 0; j < block.cols(); ++j) {
                entries.emplace_back(row, part.unknowns[static_cast<std::size_t>(j)], block(i, j));
            }
        }
    }
    for (int k = 0; k < nUnknowns(); ++k) {
        if (!isTurned[static_cast<std::size_t>(k)]) {
            entries.emplace_back(k, k, 1);
        }
    }
    basis_.resize(nUnknowns(), nUnknowns());
    basis_.setFromTriplets(entries.begin(), entries.end());
}

VectorXd MovedEdgesModel::turned(const VectorXd& forces) const {
    return turns_ ? VectorXd(basis_.transpose() * forces) : forces;
}

SparseMatrix MovedEdgesModel::turned(const SparseMatrix& matrix) const {
    if (!turns_) {
        return matrix;
    }
    const SparseMatrix right = matrix * basis_;
    return SparseMatrix(basis_.transpose()) * right;
}

void MovedEdgesModel::move(const MatrixXd& displacements) {
    assert(displacements.rows() == edge_.nPoints() && displacements.cols() == nComponents());
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        if (parts_[c].trace) {
            parts_[c].coefficients =
                parts_[c].trace->coefficients(displacements.col(static_cast<Eigen::Index>(c)));
        }
    }
}

MatrixXd MovedEdgesModel::forcesAtPoints(const VectorXd& reaction) const {
    MatrixXd forces = MatrixXd::Zero(edge_.nPoints(), nComponents());
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        if (const auto& trace = parts_[c].trace) {
            const std::vector<int> carrying(parts_[c].unknowns.begin(),
                                            parts_[c].unknowns.begin() + trace->rank());
            forces.col(static_cast<Eigen::Index>(c)) = trace->forcesAtPoints(reaction(carrying));
        }
    }
    return forces;
}

VectorXd MovedEdgesModel::prescribed(double time) const {
    VectorXd displacement = model_.prescribed(time);
    for (const Part& part : parts_) {
        for (Eigen::Index k = 0; k < part.coefficients.size(); ++k) {
            displacement[part.unknowns[static_cast<std::size_t>(k)]] = part.coefficients[k];
        }
    }
    return displacement;
}

StructuralModel::Internal MovedEdgesModel::internalForce(const VectorXd& displacement) const {
    Internal internal = model_.internalForce(ofStructure(displacement));
    internal.force = turned(internal.force);
    return internal;
}

StructuralModel::Internal MovedEdgesModel::internalForce(const VectorXd& displacement,
                                                         SparseMatrix& tangent) const {
    Internal internal = model_.internalForce(ofStructure(displacement), ownTangent_);
    internal.force = turned(internal.force);
    tangent = turned(ownTangent_);
    return internal;
}

StructuralModel::Internal MovedEdgesModel::mixedInternalForce(const VectorXd& displacement,
                                                              const VectorXd& linearisedAt,
                                                              SparseMatrix& tangent) const {
    Internal internal = model_.mixedInternalForce(ofStructure(displacement),
                                                  ofStructure(linearisedAt), ownTangent_);
    internal.force = turned(internal.force);
    tangent = turned(ownTangent_);
    return internal;
}

const VectorXd& MovedEdgesModel::externalForce(double time) {
    externalForce_ = turned(model_.externalForce(time));
    return externalForce_;
}

void MovedEdgesModel::addFollowerForce(const VectorXd& displacement, double time,
                                       VectorXd& force) const {
    VectorXd own = VectorXd::Zero(nUnknowns());
    model_.addFollowerForce(ofStructure(displacement), time, own);
    force += turned(own);
}

void MovedEdgesModel::subtractFollowerDerivative(const VectorXd& displacement, double time,
                                                 SparseMatrix& tangent) const {
    SparseMatrix own = ownTangent_;
    std::fill(own.valuePtr(), own.valuePtr() + own.nonZeros(), 0.0);
    model_.subtractFollowerDerivative(ofStructure(displacement), time, own);
    tangent += turned(own);
}

StructuralModel::SupportShift MovedEdgesModel::supportShift(double time) const {
    SupportShift shift = model_.supportShift(time);
    if (shift.force.size() > 0) {
        shift.force = turned(shift.force);
    }
    return shift;
}

std::vector<std::string> MovedEdgesModel::freeRigidMotions() const {
    std::vector<std::string> ofStructure = model_.freeRigidMotions();
    if (ofStructure.empty()) {
        return ofStructure;
    }
    RigidMotions motions(edge_.points());
    if (nComponents() == 2) {
        motions.holdInPlane();
    }
    for (int c = 0; c < nComponents(); ++c) {
        for (int k = 0; trace(c) && k < edge_.nPoints(); ++k) {
            motions.holdPoint(edge_.points().row(k), Eigen::Vector3d::Unit(c));
        }
    }
    const VectorXd unknownOf = unknownsOfControlPoints(model_);
    for (Eigen::Index k = 0; k < unknownOf.size(); ++k) {
        if (model_.fixed()[static_cast<std::size_t>(std::lround(unknownOf[k]))]) {
            motions.holdPoint(controlPoints_.row(k / nComponents()),
                              Eigen::Vector3d::Unit(k % nComponents()));
        }
    }
    return motions.freeOnes();
}

} // namespace tokay::structure
