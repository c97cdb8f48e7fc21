// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/loads/FollowerLoads.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using BaseVectors = Eigen::Matrix<double, 3, 2>;

BaseVectors currentBaseVectors(const PatchLocation& place, const VectorXd& displacement) {
    BaseVectors a = place.baseVectors;
    for (std::size_t k = 0; k < place.nodes.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        a += displacement.segment<3>(3 * place.nodes[k]) *
             place.N.block<2, 1>(1, column).transpose();
    }
    return a;
}

/// Outward across an edge, o = t x a3, t being the unit tangent along which the
/// trimming loop keeps the surface on its left.
class Outward {
  public:
    Outward(const BaseVectors& a, const Eigen::Vector2d& parameterTangent)
        : normal_(a.col(0), a.col(1)), parameterTangent_(parameterTangent),
          tangent_(a * parameterTangent), length_(tangent_.norm()) {
        tangent_ /= length_;
    }
    Vector3d value() const { return tangent_.cross(normal_.value()); }
    /// By (a1, a2).
    Eigen::Matrix<double, 3, 6> derivative() const {
        const Matrix3d turn = (Matrix3d::Identity() - tangent_ * tangent_.transpose()) / length_;
        const Matrix3d byTangent = -skew(normal_.value()) * turn;
        Eigen::Matrix<double, 3, 6> derivative = skew(tangent_) * normal_.derivative();
        derivative.leftCols<3>() += parameterTangent_[0] * byTangent;
        derivative.rightCols<3>() += parameterTangent_[1] * byTangent;
        return derivative;
    }
    const UnitNormal& normal() const { return normal_; }

  private:
    UnitNormal normal_;
    Eigen::Vector2d parameterTangent_;
    Vector3d tangent_;
    double length_;
};

// Rows (a1, a2) of a place by the displacements of its nodes.
MatrixXd baseVectorRows(const PatchLocation& place) {
    MatrixXd rows = MatrixXd::Zero(6, 3 * place.N.cols());
    for (Eigen::Index k = 0; k < place.N.cols(); ++k) {
        rows.block<3, 3>(0, 3 * k).diagonal().setConstant(place.N(1, k));
        rows.block<3, 3>(3, 3 * k).diagonal().setConstant(place.N(2, k));
    }
    return rows;
}

} // namespace

FollowerLoads::FollowerLoads(const ShellLoads& loads, const geometry::BrepModel& model,
                             const ShellPatches& patches, const ElementRows& sweep)
    : pressures_(loads.pressures), patches_(patches), sweep_(sweep) {
    for (const ShellLoads::EdgeMoment& load : loads.edgeMoments) {
        moments_.push_back({load.moment, edgePoints(*patches[load.trim.face],
                                                    model.curve(load.trim.face, load.trim.curve))});
    }
}

double FollowerLoads::pressureAt(const ShellElement& element, double time) const {
    double sum = 0;
    for (const ShellLoads::Pressure& load : pressures_) {
        for (const int face : load.faces) {
            if (patches_[face].get() == &element.patch()) {
                sum += load.pressure.value(element.position(), time);
            }
        }
    }
    return sum;
}

// The force p N a1 x a2 of each function N, and its derivative by (a1, a2).
FollowerLoads::Answer FollowerLoads::pressureOn(ShellElement& element, const VectorXd& displacement,
                                                double time, Wanted wanted) const {
    ShellElement::Coefficients u;
    element.gather(displacement, u);
    const int n = element.nFunctions();
    Answer answer{VectorXd::Zero(3 * n), MatrixXd()};
    if (wanted == Wanted::derivative) {
        answer.derivative.setZero(3 * n, 3 * n);
    }
    for (int point = 0; point < element.nPoints(); ++point) {
        element.moveToPoint(point);
        const SurfaceFunctions& functions = element.functions();
        const SurfaceDerivatives a = element.reference().derivatives + functions.derivatives(u);
        const double factor =
            pressureAt(element, time) * element.area() / element.reference().normal.area();
        const Eigen::Map<const Eigen::RowVectorXd> N(functions.row(0), n);
        const Vector3d force = factor * a.col(0).cross(a.col(1));
        Eigen::Map<Eigen::Matrix3Xd>(answer.force.data(), 3, n) += force * N;
        for (int l = 0; l < n && wanted == Wanted::derivative; ++l) {
            const Matrix3d block = factor * (functions.row(2)[l] * skew(a.col(0)) -
                                             functions.row(1)[l] * skew(a.col(1)));
            for (int k = 0; k < n; ++k) {
                answer.derivative.block<3, 3>(3 * k, 3 * l) += N[k] * block;
            }
        }
    }
    return answer;
}

// The moment does work on the turn of a3 towards the outward direction.
FollowerLoads::Answer FollowerLoads::momentAt(const EdgePoint& point, double moment,
                                              const VectorXd& displacement, Wanted wanted) {
    const Outward outward(currentBaseVectors(point.side, displacement), point.side.tangent);
    const UnitNormal& normal = outward.normal();
    const MatrixXd rows = point.weight * moment * baseVectorRows(point.side);
    Answer answer{rows.transpose() * normal.gradient(outward.value()), MatrixXd()};
    if (wanted == Wanted::derivative) {
        const Matrix6d derivative = normal.hessian(outward.value()) +
                                    normal.derivative().transpose() * outward.derivative();
        answer.derivative = rows.transpose() * derivative * baseVectorRows(point.side);
    }
    return answer;
}

template <class Use>
void FollowerLoads::forEachAnswer(const VectorXd& displacement, double time, Wanted wanted,
                                  Use use) const {
    if (!pressures_.empty()) {
        sweep_.forEachElement(1, [&](ShellElement& element, int, int) {
            use(element.nodes(), pressureOn(element, displacement, time, wanted));
        });
    }
    for (const Moment& load : moments_) {
        for (const EdgePoint& point : load.points) {
            const double moment = load.moment.value(point.side.position, time);
            use(point.side.nodes, momentAt(point, moment, displacement, wanted));
        }
    }
}

void FollowerLoads::addForce(const VectorXd& displacement, double time, VectorXd& force) const {
    forEachAnswer(displacement, time, Wanted::force,
                  [&](const std::vector<int>& nodes, const Answer& answer) {
                      for (std::size_t k = 0; k < nodes.size(); ++k) {
                          force.segment<3>(3 * nodes[k]) +=
                              answer.force.segment<3>(3 * static_cast<Eigen::Index>(k));
                      }
                  });
}

void FollowerLoads::subtractDerivative(const VectorXd& displacement, double time,
                                       const NodePattern& pattern, double* values) const {
    forEachAnswer(displacement, time, Wanted::derivative,
                  [&](const std::vector<int>& nodes, const Answer& answer) {
                      pattern.add(nodes, -answer.derivative, values);
                  });
}

} // namespace tokay::structure
