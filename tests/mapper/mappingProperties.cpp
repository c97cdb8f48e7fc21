// SPDX-License-Identifier: GPL-3.0-or-later
#include "mappingProperties.hpp"

#include "mapper/conservation.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace tokay::mapper {

Points linearField(const Points& x) {
    Eigen::Matrix3d slope;
    slope << 0.3, -1, 0.5, 2, 0.7, -0.2, 0.1, 0.4, -0.6;
    return (x * slope).rowwise() + Eigen::RowVector3d(0.7, -0.4, 1.1);
}

void expectTransposesEqual(const Mapping& mapping, int nFrom, int nTo) {
    const Points values = probeForces(nFrom).array().cos(), forces = probeForces(nTo).array().sin();
    const Points mapped = mapping.apply(values), transposed = mapping.applyTransposed(forces);
    const double scale = mapped.norm() * forces.norm() + values.norm() * transposed.norm();
    // The two sides are sums of the same products in another order; what was
    // inverted enlarges their rounding.
    EXPECT_NEAR(mapped.cwiseProduct(forces).sum(), values.cwiseProduct(transposed).sum(),
                1e-13 * scale);
}

void expectForceAndMomentConserved(const Mapping& mapping, const Points& forces, const Points& from,
                                   const Points& to) {
    const auto moment = [](const Points& x, const Points& f) {
        Point sum = Point::Zero();
        for (Eigen::Index i = 0; i < x.rows(); ++i) {
            sum += Point(x.row(i)).cross(Point(f.row(i)));
        }
        return sum;
    };
    const Points mapped = mapping.applyTransposed(forces);
    const double total = forces.rowwise().norm().sum();
    EXPECT_LT((mapped.colwise().sum() - forces.colwise().sum()).norm(), 1e-12 * total);
    EXPECT_LT((moment(from, mapped) - moment(to, forces)).norm(), 1e-12 * total);
}

} // namespace tokay::mapper
