// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/SolidLoading.hpp"

#include "igaStructure/assembly/UnitNormal.hpp"
#include "igaStructure/kinematics/solid/SidePoints.hpp"
#include "igaStructure/kinematics/solid/SolidElement.hpp"

#include <Eigen/Geometry>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using SideElement = SidePoints::SideElement;
using SidePoint = SidePoints::SidePoint;

void add(const SideElement& element, const SidePoint& point, const Vector3d& load,
         VectorXd& force) {
    for (std::size_t k = 0; k < element.controlPoints.size(); ++k) {
        force.segment<3>(3 * element.controlPoints[k]) +=
            point.N(0, static_cast<Eigen::Index>(k)) * load;
    }
}

// Tangents of the moved side.
Eigen::Matrix<double, 3, 2> currentTangents(const SideElement& element, const SidePoint& point,
                                            const VectorXd& displacement) {
    Eigen::Matrix<double, 3, 2> a;
    a << point.tangentXi, point.tangentEta;
    for (std::size_t k = 0; k < element.controlPoints.size(); ++k) {
        a += displacement.segment<3>(3 * element.controlPoints[k]) *
             point.N.block<2, 1>(1, static_cast<Eigen::Index>(k)).transpose();
    }
    return a;
}

} // namespace

SolidLoading::SolidLoading(const SolidDescription& description)
    : volume_(description.volume), density_(description.material.density),
      loads_(description.loads), sides_(6),
      constant_(VectorXd::Zero(3 * description.volume.nControlPoints())) {
    const auto prepare = [&](geometry::Side side) {
        auto& points = sides_[static_cast<int>(side)];
        if (!points) {
            points = std::make_unique<SidePoints>(volume_, side);
        }
    };
    for (const SolidLoads::Traction& load : loads_.tractions) {
        prepare(load.side);
    }
    for (const SolidLoads::Pressure& load : loads_.pressures) {
        prepare(load.side);
    }
    addDead(0, false, constant_);
}

SolidLoading::~SolidLoading() = default;

VectorXd SolidLoading::deadForce(double time) const {
    VectorXd force = constant_;
    addDead(time, true, force);
    return force;
}

void SolidLoading::addDead(double time, bool varying, VectorXd& force) const {
    for (const SolidLoads::Traction& load : loads_.tractions) {
        if (load.traction.dependsOnTime != varying) {
            continue;
        }
        for (const SideElement& element : sides_[static_cast<int>(load.side)]->elements()) {
            for (const SidePoint& point : element.points) {
                const double area = point.weight * point.tangentXi.cross(point.tangentEta).norm();
                add(element, point, area * load.traction.value(point.position, time), force);
            }
        }
    }
    for (const VectorField& gravity : loads_.gravities) {
        if (gravity.dependsOnTime == varying) {
            addGravity(gravity, time, force);
        }
    }
}

void SolidLoading::addGravity(const VectorField& gravity, double time, VectorXd& force) const {
    constexpr int additionalPoints = 1; // formulas need not be polynomials
    const PatchNodes controlPoints({volume_.u(), volume_.v(), volume_.w()}, volume_.controlPoints(),
                                   volume_.weights(), true);
    const SolidGrid grid(volume_, controlPoints, additionalPoints);
    SolidElement element(grid);
    SolidElement::Coefficients local(3, grid.nFunctions());
    for (int number = 0; number < grid.nElements(); ++number) {
        const int nU = grid.basis[0].nSpans();
        const int nV = grid.basis[1].nSpans();
        element.moveToElement({number % nU, number / nU % nV, number / nU / nV});
        local.setZero();
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const Vector3d pull =
                density_ * element.volume() * gravity.value(element.position(), time);
            local += pull * element.values().transpose();
        }
        element.scatter(local, force);
    }
}

VectorXd SolidLoading::pressure(const VectorXd& displacement, double time) const {
    VectorXd force = VectorXd::Zero(displacement.size());
    for (const SolidLoads::Pressure& load : loads_.pressures) {
        const SidePoints& side = *sides_[static_cast<int>(load.side)];
        for (const SideElement& element : side.elements()) {
            for (const SidePoint& point : element.points) {
                const auto a = currentTangents(element, point, displacement);
                const double factor =
                    -side.outwards() * point.weight * load.pressure.value(point.position, time);
                add(element, point, factor * a.col(0).cross(a.col(1)), force);
            }
        }
    }
    return force;
}

void SolidLoading::subtractPressureDerivative(const VectorXd& displacement, double time,
                                              const PatchNodes& nodes, const NodePattern& pattern,
                                              double* values) const {
    for (const SolidLoads::Pressure& load : loads_.pressures) {
        const SidePoints& side = *sides_[static_cast<int>(load.side)];
        for (const SideElement& element : side.elements()) {
            const auto n = static_cast<Eigen::Index>(element.controlPoints.size());
            Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(3 * n, 3 * n);
            for (const SidePoint& point : element.points) {
                const auto a = currentTangents(element, point, displacement);
                const double factor =
                    -side.outwards() * point.weight * load.pressure.value(point.position, time);
                const Matrix3d byXi = -factor * skew(a.col(1));
                const Matrix3d byEta = factor * skew(a.col(0));
                for (Eigen::Index l = 0; l < n; ++l) {
                    const Matrix3d block = point.N(1, l) * byXi + point.N(2, l) * byEta;
                    for (Eigen::Index k = 0; k < n; ++k) {
                        derivative.block<3, 3>(3 * k, 3 * l) += point.N(0, k) * block;
                    }
                }
            }
            pattern.add(nodes.of(element.controlPoints), -derivative, values);
        }
    }
}

} // namespace tokay::structure
