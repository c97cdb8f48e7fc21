// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/EdgeCoupling.hpp"

#include "igaStructure/assembly/UnitNormal.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Unit tangent t of an edge, t1 a1 + t2 a2 made a unit vector.
class UnitTangent {
  public:
    UnitTangent(const Eigen::Matrix<double, 3, 2>& a, const Eigen::Vector2d& parameters)
        : parameters_(parameters), tangent_(a * parameters), length_(tangent_.norm()) {
        tangent_ /= length_;
    }
    const Vector3d& value() const { return tangent_; }
    Eigen::Matrix<double, 3, 6> derivative() const { return byBaseVectors(projector() / length_); }
    Matrix6d hessian(const Vector3d& direction) const {
        const double along = direction.dot(tangent_);
        const Vector3d across = direction - along * tangent_;
        const Matrix3d second =
            -(across * tangent_.transpose() + tangent_ * across.transpose() + along * projector()) /
            (length_ * length_);
        Matrix6d hessian;
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 2; ++j) {
                hessian.block<3, 3>(3 * i, 3 * j) = parameters_[i] * parameters_[j] * second;
            }
        }
        return hessian;
    }

  private:
    Matrix3d projector() const { return Matrix3d::Identity() - tangent_ * tangent_.transpose(); }
    Eigen::Matrix<double, 3, 6> byBaseVectors(const Matrix3d& byTangent) const {
        Eigen::Matrix<double, 3, 6> derivative;
        derivative << parameters_[0] * byTangent, parameters_[1] * byTangent;
        return derivative;
    }

    Eigen::Vector2d parameters_;
    Vector3d tangent_;
    double length_;
};

// Second derivative of t . (m x n) by both base vectors of n and t, then those of m.
MatrixXd sineHessian(const UnitNormal& n, const UnitNormal& m, const UnitTangent& t) {
    const Vector3d byT = m.value().cross(n.value());
    const Vector3d byM = n.value().cross(t.value());
    const Vector3d byN = t.value().cross(m.value());
    const Eigen::Matrix<double, 3, 6> dn = n.derivative();
    const Eigen::Matrix<double, 3, 6> dm = m.derivative();
    const Eigen::Matrix<double, 3, 6> dt = t.derivative();
    const Matrix6d tn = dt.transpose() * skew(m.value()) * dn;
    const Matrix6d tm = -dt.transpose() * skew(n.value()) * dm;
    const Matrix6d mn = -dm.transpose() * skew(t.value()) * dn;
    const Matrix6d own = t.hessian(byT) + n.hessian(byN) + tn + tn.transpose();
    const Matrix6d mixed = tm + mn.transpose();
    MatrixXd hessian(12, 12);
    hessian << own, mixed, mixed.transpose(), m.hessian(byM);
    return hessian;
}

} // namespace

EdgeCoupling::EdgeCoupling(const PatchLocation& side, const PatchLocation* other)
    : nodes_(side.nodes) {
    if (other) {
        nodes_.insert(nodes_.end(), other->nodes.begin(), other->nodes.end());
    }
}

VectorXd EdgeCoupling::gathered(const VectorXd& displacement) const {
    VectorXd local(3 * nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        local.segment<3>(3 * static_cast<Eigen::Index>(k)) = displacement.segment<3>(3 * nodes_[k]);
    }
    return local;
}

DisplacementPenalty::DisplacementPenalty(const PatchLocation& side, const PatchLocation* other,
                                         const std::array<bool, 3>& components,
                                         const Matrix3d& stiffness, double mass)
    : EdgeCoupling(side, other), components_(components), places_{{side.position, 1}},
      elastic_(stiffness), stiffness_(stiffness), mass_(mass), row_(nodes_.size()) {
    row_.head(side.N.cols()) = side.N.row(0);
    if (other) {
        row_.tail(other->N.cols()) = -other->N.row(0);
    }
}

DisplacementPenalty::DisplacementPenalty(std::vector<int> nodes, Eigen::RowVectorXd weights,
                                         const std::array<bool, 3>& components,
                                         const Matrix3d& stiffness, double mass,
                                         std::vector<WeightedPlace> places)
    : EdgeCoupling(std::move(nodes)), components_(components), places_(std::move(places)),
      elastic_(stiffness), stiffness_(stiffness), mass_(mass), row_(std::move(weights)) {}

void DisplacementPenalty::resistInertia(double massFactor) {
    stiffness_ = elastic_ + massFactor * mass_ * Matrix3d::Identity();
}

EdgeCoupling::Answer DisplacementPenalty::answer(const VectorXd& displacement, Strains,
                                                 bool withTangent) const {
    const MatrixXd rows = restRows();
    const VectorXd held = rows * gathered(displacement);
    const MatrixXd stiff = stiffness_ * rows;
    Answer answer{stiff.transpose() * held, {}, 0.5 * held.dot(stiffness_ * held)};
    if (withTangent) {
        answer.tangent = rows.transpose() * stiff;
    }
    return answer;
}

EdgeCoupling::Shift DisplacementPenalty::shift(const VectorField& motion, double time) const {
    Vector3d sum = Vector3d::Zero();
    Shift shift;
    for (const WeightedPlace& place : places_) {
        Vector3d value = motion.value(place.position, time);
        for (int c = 0; c < 3; ++c) {
            value[c] = components_[c] ? value[c] : 0;
        }
        sum += place.factor * value;
        shift.largest = std::max(shift.largest, value.lpNorm<Eigen::Infinity>());
    }
    shift.force = -restRows().transpose() * (stiffness_ * sum);
    shift.energy = 0.5 * sum.dot(stiffness_ * sum);
    return shift;
}

MatrixXd DisplacementPenalty::restRows() const {
    MatrixXd rows = MatrixXd::Zero(3, 3 * row_.size());
    for (int c = 0; c < 3; ++c) {
        if (components_[c]) {
            for (Eigen::Index k = 0; k < row_.size(); ++k) {
                rows(c, 3 * k + c) = row_[k];
            }
        }
    }
    return rows;
}

RotationPenalty::RotationPenalty(const PatchLocation& side, const PatchLocation* other,
                                 double stiffness)
    : EdgeCoupling(side, other), locations_{side}, stiffness_(stiffness),
      conormal_(side.normal().cross(side.baseVectors * side.tangent)) {
    if (other) {
        locations_.push_back(*other);
    }
    rows_ = MatrixXd::Zero(6 * static_cast<Eigen::Index>(locations_.size()), 3 * nodes_.size());
    Eigen::Index column = 0;
    for (std::size_t place = 0; place < locations_.size(); ++place) {
        const MatrixXd& N = locations_[place].N;
        for (Eigen::Index k = 0; k < N.cols(); ++k, column += 3) {
            for (int i = 0; i < 2; ++i) {
                rows_.block<3, 3>(6 * static_cast<Eigen::Index>(place) + 3 * i, column)
                    .diagonal()
                    .setConstant(N(1 + i, k));
            }
        }
    }
    atRest_ = measures(current(VectorXd()), false);
}

RotationPenalty::BaseVectors RotationPenalty::current(const VectorXd& displacement) const {
    BaseVectors a;
    VectorXd change = VectorXd::Zero(rows_.rows());
    if (displacement.size() > 0) {
        change = rows_ * gathered(displacement);
    }
    for (std::size_t place = 0; place < locations_.size(); ++place) {
        a.push_back(locations_[place].baseVectors +
                    Eigen::Map<const Eigen::Matrix<double, 3, 2>>(change.data() + 6 * place));
    }
    return a;
}

std::vector<RotationPenalty::Measure> RotationPenalty::measures(const BaseVectors& a,
                                                                bool withHessian) const {
    const UnitNormal n(a[0].col(0), a[0].col(1));
    if (locations_.size() == 1) {
        Measure alone{n.value().dot(conormal_), n.gradient(conormal_), {}};
        if (withHessian) {
            alone.hessian = n.hessian(conormal_);
        }
        return {std::move(alone)};
    }
    const UnitNormal m(a[1].col(0), a[1].col(1));
    const UnitTangent t(a[0], locations_[0].tangent);
    Measure cosine{n.value().dot(m.value()), VectorXd(12), {}};
    cosine.gradient << n.gradient(m.value()), m.gradient(n.value());
    // t . (m x n), the sine of the angle between the normals.
    const Vector3d byT = m.value().cross(n.value());
    Measure sine{t.value().dot(byT), VectorXd(12), {}};
    sine.gradient << t.derivative().transpose() * byT + n.gradient(t.value().cross(m.value())),
        m.gradient(n.value().cross(t.value()));
    if (withHessian) {
        const Matrix6d nm = n.derivative().transpose() * m.derivative();
        cosine.hessian.resize(12, 12);
        cosine.hessian << n.hessian(m.value()), nm, nm.transpose(), m.hessian(n.value());
        sine.hessian = sineHessian(n, m, t);
    }
    return {std::move(cosine), std::move(sine)};
}

std::vector<RotationPenalty::Measure>
RotationPenalty::changes(const VectorXd& displacement, Strains strains, bool withHessian) const {
    if (strains == Strains::linear) {
        std::vector<Measure> found = atRest_;
        const VectorXd change = rows_ * gathered(displacement);
        for (Measure& measure : found) {
            measure.value = measure.gradient.dot(change);
        }
        return found;
    }
    std::vector<Measure> found = measures(current(displacement), withHessian);
    for (std::size_t k = 0; k < found.size(); ++k) {
        found[k].value -= atRest_[k].value;
    }
    return found;
}

EdgeCoupling::Answer RotationPenalty::answer(const VectorXd& displacement, Strains strains,
                                             bool withTangent) const {
    Answer answer;
    VectorXd gradient = VectorXd::Zero(rows_.rows());
    MatrixXd hessian = MatrixXd::Zero(rows_.rows(), rows_.rows());
    for (const Measure& measure : changes(displacement, strains, withTangent)) {
        gradient += stiffness_ * measure.value * measure.gradient;
        answer.energy += 0.5 * stiffness_ * measure.value * measure.value;
        if (withTangent) {
            hessian += stiffness_ * measure.gradient * measure.gradient.transpose();
        }
        if (measure.hessian.size() > 0) {
            hessian += stiffness_ * measure.value * measure.hessian;
        }
    }
    answer.force = rows_.transpose() * gradient;
    if (withTangent) {
        answer.tangent = rows_.transpose() * hessian * rows_;
    }
    return answer;
}

MatrixXd RotationPenalty::restRows() const {
    MatrixXd rows(atRest_.size(), rows_.cols());
    for (std::size_t k = 0; k < atRest_.size(); ++k) {
        rows.row(static_cast<Eigen::Index>(k)) = atRest_[k].gradient.transpose() * rows_;
    }
    return rows;
}

} // namespace tokay::structure
