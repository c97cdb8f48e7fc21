// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/NitscheCoupling.hpp"

#include "igaStructure/kinematics/shell/edges/CutFractions.hpp"
#include "igaStructure/kinematics/shell/edges/EdgeTraction.hpp"
#include "igaStructure/kinematics/shell/edges/NodeUnion.hpp"
#include "igaStructure/kinematics/shell/edges/PenaltyStiffness.hpp"
#include "igaStructure/kinematics/shell/edges/TractionBounds.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

NitscheCoupling::NitscheCoupling(std::vector<int> nodes, MatrixXd held, MatrixXd traction,
                                 MatrixXd stabilisation, double mass)
    : EdgeCoupling(std::move(nodes)), held_(std::move(held)), traction_(std::move(traction)),
      elastic_(std::move(stabilisation)), stabilisation_(elastic_), mass_(mass) {}

void NitscheCoupling::resistInertia(double massFactor) {
    stabilisation_ = elastic_;
    stabilisation_.topLeftCorner<3, 3>() += massFactor * mass_ * Matrix3d::Identity();
}

EdgeCoupling::Answer NitscheCoupling::answer(const VectorXd& displacement, Strains,
                                             bool withTangent) const {
    const VectorXd u = gathered(displacement);
    const VectorXd held = held_ * u;
    const VectorXd traction = traction_ * u;
    const VectorXd coupling = stabilisation_ * held - traction;
    Answer answer{held_.transpose() * coupling - traction_.transpose() * held,
                  {},
                  0.5 * held.dot(coupling - traction)};
    if (withTangent) {
        // held^T (stabilisation / 2 held - traction), made symmetric.
        const MatrixXd half = held_.transpose() * (0.5 * stabilisation_ * held_ - traction_);
        answer.tangent = half + half.transpose();
    }
    return answer;
}

void NitscheCoupling::followAt(const Vector3d& position, const Vector3d& step,
                               const Vector3d& components) {
    position_ = position;
    step_ = step;
    components_ = components;
}

EdgeCoupling::Shift NitscheCoupling::shift(const VectorField& motion, double time) const {
    const Vector3d forward = motion.value(position_ + step_, time);
    const Vector3d backward = motion.value(position_ - step_, time);
    VectorXd prescribed = VectorXd::Zero(7);
    prescribed.head<3>() = components_.cwiseProduct(motion.value(position_, time));
    prescribed.segment<3>(3) = components_.cwiseProduct(forward - backward) / (2 * step_.norm());
    const VectorXd stiff = stabilisation_ * prescribed;
    return {traction_.transpose() * prescribed - held_.transpose() * stiff,
            0.5 * prescribed.dot(stiff), prescribed.head<3>().lpNorm<Eigen::Infinity>()};
}

namespace {

// One side of an edge: the elements whose tractions are taken.
class Side {
  public:
    Side(const ShellPatch& patch, const HeldMotion& held)
        : patch_(patch), held_(held), fractions_(patch) {}

    /// The place is borrowed until findBounds().
    void add(const PatchLocation& place, double length) {
        pieces_[fractions_.standIn(place.element)].push_back({&place, length});
    }

    void findBounds() {
        for (const auto& [element, pieces] : pieces_) {
            bounds_[element] = tractionBounds(patch_, element, pieces, held_);
            largest_.enlarge(bounds_[element]);
        }
        pieces_.clear();
    }

    EdgeTraction traction(const PatchLocation& place) const {
        return {place, fractions_.standIn(place.element), held_.bending};
    }
    const TractionBounds& bounds(const PatchLocation& place) const {
        return bounds_.at(fractions_.standIn(place.element));
    }
    /// Largest stiffness among the constrained components.
    double largest() const {
        return !held_.bending       ? largest_.membrane
               : held_.displacement ? largest_.shear
                                    : largest_.moment;
    }

  private:
    const ShellPatch& patch_;
    HeldMotion held_;
    CutFractions fractions_;
    std::map<int, std::vector<EdgePiece>> pieces_;
    std::map<int, TractionBounds> bounds_;
    TractionBounds largest_;
};

// Displacement, its derivative along the edge and the rotation at a place.
MatrixXd motionRows(const PatchLocation& place) {
    const RowVectorXd along = place.tangent.transpose() * place.N.bottomRows<2>();
    const RowVectorXd across = place.conormal().transpose() * place.N.bottomRows<2>();
    MatrixXd rows = MatrixXd::Zero(7, 3 * place.N.cols());
    for (Eigen::Index k = 0; k < place.N.cols(); ++k) {
        rows.block<3, 3>(0, 3 * k).diagonal().setConstant(place.N(0, k));
        rows.block<3, 3>(3, 3 * k).diagonal().setConstant(along[k]);
        rows.block<1, 3>(6, 3 * k) = across[k] * place.normal().transpose();
    }
    return rows;
}

MatrixXd tractionRows(const EdgeTraction& traction) {
    MatrixXd rows(7, traction.force.cols());
    rows << traction.force, traction.twist, -traction.moment;
    return rows;
}

// Two edges may meet in an element; each takes a third of its energy at most.
MatrixXd stabilisation(const TractionBounds& bounds, const Vector3d& normal, bool bending) {
    constexpr double share = 3;
    const Matrix3d across = normal * normal.transpose();
    MatrixXd matrix = MatrixXd::Zero(7, 7);
    matrix.topLeftCorner<3, 3>() = bounds.membrane * Matrix3d::Identity();
    if (bending) {
        matrix.topLeftCorner<3, 3>() += (bounds.shear - bounds.membrane) * across;
    }
    matrix.block<3, 3>(3, 3) = bounds.twist * across;
    matrix(6, 6) = bounds.moment;
    return share * matrix;
}

class NitscheBuilder {
  public:
    NitscheBuilder(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                   bool rotation, bool bending, double factor)
        : factor_(factor), bending_(bending) {
        for (int c = 0; c < 3; ++c) {
            held_[c] = held_[3 + c] = components[c] ? 1 : 0;
        }
        held_[6] = rotation ? 1 : 0;
        const HeldMotion held{components != std::array<bool, 3>{}, rotation, bending};
        sides_.emplace_back(*points.front().side.patch, held);
        if (points.front().other) {
            sides_.emplace_back(*points.front().other->patch, held);
        }
        for (const EdgePoint& point : points) {
            sides_[0].add(point.side, point.weight);
            if (point.other) {
                sides_[1].add(*point.other, point.weight);
            }
        }
        for (Side& side : sides_) {
            side.findBounds();
        }
        if (sides_.size() > 1) {
            const double first = sides_[0].largest(), second = sides_[1].largest();
            weights_ = {second / (first + second), first / (first + second)};
        }
    }

    std::unique_ptr<EdgeCoupling> coupling(const EdgePoint& point) const {
        const PatchLocation* places[2] = {&point.side, point.other ? &*point.other : nullptr};
        NodeUnion nodes;
        std::vector<MatrixXd> motions, tractions;
        std::vector<std::vector<Eigen::Index>> motionColumns, tractionColumns;
        MatrixXd stiffness = MatrixXd::Zero(7, 7);
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const EdgeTraction traction = sides_[s].traction(*places[s]);
            motions.push_back(motionRows(*places[s]));
            tractions.push_back(tractionRows(traction));
            motionColumns.push_back(nodes.add(places[s]->nodes));
            tractionColumns.push_back(nodes.add(traction.nodes));
            stiffness += weights_[s] * weights_[s] *
                         stabilisation(sides_[s].bounds(*places[s]), places[s]->normal(), bending_);
        }
        const auto n = 3 * nodes.size();
        MatrixXd held = MatrixXd::Zero(7, n), traction = MatrixXd::Zero(7, n);
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const VectorXd signs = s == 0 ? VectorXd::Ones(7) : otherSigns(point);
            addColumns(held_.cwiseProduct(signs).asDiagonal() * motions[s], motionColumns[s], 1,
                       held);
            addColumns(signs.asDiagonal() * tractions[s], tractionColumns[s], weights_[s],
                       traction);
        }
        constexpr double elements = 1000; // as many as penalty has
        const PenaltyStiffness springs = {factor_ * elements, 0, 0};
        auto coupling = std::make_unique<NitscheCoupling>(
            nodes.nodes(), std::move(held), point.weight * traction,
            factor_ * point.weight * stiffness, point.weight * springs.massOfDisplacement(point));
        constexpr double part = 1e-4; // exact to digits, and far from rounding
        coupling->followAt(point.side.position,
                           part * point.side.elementLength() * point.side.baseVectors *
                               point.side.tangent,
                           held_.head<3>());
        return coupling;
    }

  private:
    // Jumps are the first side's minus the other's, whose edge may run the other way.
    static VectorXd otherSigns(const EdgePoint& point) {
        const Vector3d first = point.side.baseVectors * point.side.tangent;
        const Vector3d second = point.other->baseVectors * point.other->tangent;
        const double way = first.dot(second) > 0 ? 1 : -1;
        VectorXd signs(7);
        signs << -1, -1, -1, -way, -way, -way, -way;
        return signs;
    }

    double factor_;
    bool bending_;
    Eigen::Matrix<double, 7, 1> held_;
    std::vector<Side> sides_;
    std::array<double, 2> weights_ = {1, 0};
};

} // namespace

std::vector<std::unique_ptr<EdgeCoupling>> nitscheCouplings(const std::vector<EdgePoint>& points,
                                                            const std::array<bool, 3>& components,
                                                            bool rotation, bool bending,
                                                            double factor) {
    std::vector<std::unique_ptr<EdgeCoupling>> couplings;
    if (points.empty()) {
        return couplings;
    }
    const NitscheBuilder builder(points, components, rotation, bending, factor);
    for (const EdgePoint& point : points) {
        couplings.push_back(builder.coupling(point));
    }
    return couplings;
}

} // namespace tokay::structure
