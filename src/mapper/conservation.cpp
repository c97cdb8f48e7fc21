// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/conservation.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace tokay::mapper {

namespace {

Point moment(const Points& positions, const Points& forces, const Point& about) {
    Point sum = Point::Zero();
    for (Eigen::Index i = 0; i < positions.rows(); ++i) {
        const Point arm = positions.row(i).transpose() - about;
        sum += arm.cross(Point(forces.row(i)));
    }
    return sum;
}

} // namespace

Points probeForces(Eigen::Index n) {
    Points forces(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        forces.row(i) << 1 + std::sin(1.0 + i), std::cos(2.0 * i) - 0.5, std::sin(3.0 * i) + 0.3;
    }
    return forces;
}

void measureConservation(const Mapping& mapping, const Points& forces, const Points& from,
                         const Points& to, MappingReport& report) {
    const Points mapped = mapping.applyTransposed(forces);
    const double total = forces.rowwise().norm().sum();
    report.forceSumError = (forces.colwise().sum() - mapped.colwise().sum()).norm() / total;

    const Point about = to.colwise().mean();
    const double arm =
        std::sqrt((to.rowwise() - about.transpose()).rowwise().squaredNorm().maxCoeff());
    const Point lost = moment(to, forces, about) - moment(from, mapped, about);
    report.momentError = arm > 0 ? lost.norm() / (arm * total) : 0;
}

} // namespace tokay::mapper
