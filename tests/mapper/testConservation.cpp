// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/conservation.hpp"

#include <gtest/gtest.h>

namespace tokay::mapper {

namespace {

/// Passes on a part of each force.
class Lossy : public Mapping {
  public:
    explicit Lossy(double part) : part_(part) {}
    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override { return part_ * values; }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        return part_ * forces;
    }

  private:
    double part_;
};

MappingReport measured(const Mapping& mapping, const Points& forces, const Points& from,
                       const Points& to) {
    MappingReport report;
    measureConservation(mapping, forces, from, to, report);
    return report;
}

} // namespace

TEST(Conservation, lost_force_and_moment_are_told_as_parts_of_what_acts) {
    // Forces 1 N and 3 N across the line between points 4 m apart.
    Points at(2, 3), forces(2, 3);
    at << 10, 5, 0, 14, 5, 0;
    forces << 0, 0, 1, 0, 0, 3;
    const MappingReport report = measured(Lossy(0.9), forces, at, at);
    EXPECT_NEAR(report.forceSumError, 0.1, 1e-15);
    // About the middle: 0.1 of (3 - 1) N times 2 m, over 4 N times 2 m.
    EXPECT_NEAR(report.momentError, 0.05, 1e-14);
}

TEST(Conservation, a_force_that_is_shifted_loses_its_moment_only) {
    Points from(2, 3), to(2, 3), forces(2, 3);
    to << -1, 0, 0, 1, 0, 0;
    from << -1, 0, 0, 1, 0.5, 0;
    forces << 0, 0, 0, 2, 0, 0;
    const MappingReport report = measured(Lossy(1), forces, from, to);
    EXPECT_EQ(report.forceSumError, 0);
    EXPECT_NEAR(report.momentError, 0.5, 1e-15); // 2 N times 0.5 m, over 2 N times 1 m
}

} // namespace tokay::mapper
