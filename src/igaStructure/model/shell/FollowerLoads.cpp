#include "igaStructure/model/shell/FollowerLoads.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

Eigen::Matrix<double, 3, 2> currentBaseVectors(const PatchPlace& place,
                                               const VectorXd& displacement) {
    Eigen::Matrix<double, 3, 2> a = place.baseVectors;
    for (std::size_t k = 0; k < place.nodes.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        a += displacement.segment<3>(3 * place.nodes[k]) *
             place.N.block<2, 1>(1, column).transpose();
    }
    return a;
}

// Outward across the edge: trimming loops keep the surface on their left.
Vector3d outward(const Eigen::Matrix<double, 3, 2>& a, const Eigen::Vector2d& tangent) {
    return (a * tangent).normalized().cross(a.col(0).cross(a.col(1)).normalized());
}

} // namespace

FollowerLoads::FollowerLoads(const ShellLoads& loads, const geometry::BrepModel& model,
                             const ShellPatches& patches, const ElementSweep& sweep)
    : pressures_(loads.pressures), patches_(patches), sweep_(sweep) {
    for (const ShellLoads::EdgeMoment& load : loads.edgeMoments) {
        moments_.push_back({load.moment, edgePoints(*patches[load.trim.face],
                                                    model.curve(load.trim.face, load.trim.curve))});
    }
}

double FollowerLoads::pressureAt(const ShellElement& element, double time) const {
    double sum = 0;
    for (const ShellLoads::Pressure& load : pressures_) {
        if (patches_[load.face].get() == &element.patch()) {
            sum += load.pressure.value(element.position(), time);
        }
    }
    return sum;
}

void FollowerLoads::addForce(const VectorXd& displacement, double time, VectorXd& force) const {
    const auto addPressure = [&](ShellElement& element, int, int) {
        ShellElement::Coefficients u;
        element.gather(displacement, u);
        ShellElement::Coefficients local = ShellElement::Coefficients::Zero(3, u.cols());
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const double pressure = pressureAt(element, time);
            const SurfaceDerivatives a =
                element.reference().derivatives + element.functions().derivatives(u);
            const Vector3d load = pressure * element.area() / element.reference().normal.area() *
                                  a.col(0).cross(a.col(1));
            for (int k = 0; k < element.nFunctions(); ++k) {
                local.col(k) += element.functions().row(0)[k] * load;
            }
        }
        element.scatter(local, force);
    };
    if (!pressures_.empty()) {
        sweep_.forEachElement(1, addPressure);
    }
    for (const Moment& load : moments_) {
        for (const EdgePoint& point : load.points) {
            const auto a = currentBaseVectors(point.side, displacement);
            const Vector6d turn =
                UnitNormal(a.col(0), a.col(1)).gradient(outward(a, point.side.tangent));
            const double moment = point.weight * load.moment.value(point.side.position, time);
            for (std::size_t k = 0; k < point.side.nodes.size(); ++k) {
                const auto column = static_cast<Eigen::Index>(k);
                force.segment<3>(3 * point.side.nodes[k]) +=
                    moment * (point.side.N(1, column) * turn.head<3>() +
                              point.side.N(2, column) * turn.tail<3>());
            }
        }
    }
}

void FollowerLoads::subtractDerivative(const VectorXd& displacement, double time,
                                       const NodePattern& pattern, double* values) const {
    const auto subtractPressure = [&](ShellElement& element, int, int) {
        ShellElement::Coefficients u;
        element.gather(displacement, u);
        const int n = element.nFunctions();
        MatrixXd derivative = MatrixXd::Zero(3 * n, 3 * n);
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const SurfaceFunctions& functions = element.functions();
            const SurfaceDerivatives a = element.reference().derivatives + functions.derivatives(u);
            const double factor =
                pressureAt(element, time) * element.area() / element.reference().normal.area();
            const Matrix3d byFirst = -factor * skew(a.col(1));
            const Matrix3d bySecond = factor * skew(a.col(0));
            for (int l = 0; l < n; ++l) {
                const Matrix3d block =
                    functions.row(1)[l] * byFirst + functions.row(2)[l] * bySecond;
                for (int k = 0; k < n; ++k) {
                    derivative.block<3, 3>(3 * k, 3 * l) += functions.row(0)[k] * block;
                }
            }
        }
        pattern.add(element.nodes(), -0.5 * (derivative + derivative.transpose()), values);
    };
    if (!pressures_.empty()) {
        sweep_.forEachElement(1, subtractPressure);
    }
    for (const Moment& load : moments_) {
        for (const EdgePoint& point : load.points) {
            const auto a = currentBaseVectors(point.side, displacement);
            const Matrix6d second =
                UnitNormal(a.col(0), a.col(1)).hessian(outward(a, point.side.tangent));
            const double moment = point.weight * load.moment.value(point.side.position, time);
            const Eigen::Index n = point.side.N.cols();
            MatrixXd rows = MatrixXd::Zero(6, 3 * n);
            for (Eigen::Index k = 0; k < n; ++k) {
                rows.block<3, 3>(0, 3 * k).diagonal().setConstant(point.side.N(1, k));
                rows.block<3, 3>(3, 3 * k).diagonal().setConstant(point.side.N(2, k));
            }
            pattern.add(point.side.nodes, -moment * rows.transpose() * second * rows, values);
        }
    }
}

} // namespace tokay::structure
