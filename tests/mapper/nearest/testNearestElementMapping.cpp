// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "mapper/conservation.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/sampleInterfaces.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

namespace {

Points unevenForces(int n) {
    Points forces(n, 3);
    for (int i = 0; i < n; ++i) {
        forces.row(i) << std::sin(1.3 * i) + 0.4, std::cos(0.7 * i), 0;
    }
    return forces;
}

Point moment(const Points& positions, const Points& forces) {
    Point sum = Point::Zero();
    for (int i = 0; i < positions.rows(); ++i) {
        sum += Point(positions.row(i)).cross(Point(forces.row(i)));
    }
    return sum;
}

} // namespace

TEST(NearestElementMapping, reproduces_rigid_motions_exactly) {
    const SplineInterface interface = flapInterface();
    const Points to = flapPoints(37);
    const NearestElementMapping mapping(interface, to);
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Point::UnitZ()).toRotationMatrix();
    const auto displacement = [&](const Points& x) -> Points {
        return ((x * rotation.transpose()) - x).rowwise() + Eigen::RowVector3d(0.3, -2, 0);
    };
    const Points mapped = mapping.apply(displacement(interface.coordinates()));
    // A chain of a few roundings of numbers of size 2.
    EXPECT_LT((mapped - displacement(to)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(NearestElementMapping, conserves_force_and_moment) {
    const SplineInterface interface = flapInterface();
    const Points to = flapPoints(37), forces = unevenForces(111);
    const NearestElementMapping mapping(interface, to);
    const Points mapped = mapping.applyTransposed(forces);
    const double total = forces.rowwise().norm().sum();
    EXPECT_LT((mapped.colwise().sum() - forces.colwise().sum()).norm(), 1e-12 * total);
    EXPECT_LT((moment(interface.coordinates(), mapped) - moment(to, forces)).norm(), 1e-12 * total);
}

TEST(NearestElementMapping, is_the_transpose_of_its_conservative_partner) {
    const SplineInterface interface = quarterCircle(3, 5);
    Points to(41, 3);
    for (int i = 0; i < 41; ++i) {
        to.row(i) << std::cos(i * 0.0392), std::sin(i * 0.0392), 0;
    }
    const NearestElementMapping mapping(interface, to);
    const Points forces = unevenForces(41);
    const Points values = interface.coordinates().array().sin();
    const double work = mapping.apply(values).cwiseProduct(forces).sum();
    EXPECT_NEAR(work, values.cwiseProduct(mapping.applyTransposed(forces)).sum(), 1e-14 * 41);
}

TEST(NearestElementMapping, evaluates_the_deformed_rational_curve_exactly) {
    const SplineInterface interface = quarterCircle(3, 5);
    const geometry::NurbsCurve& curve = interface.pieces()[0].curve;
    Points to(21, 3);
    for (int i = 0; i < 21; ++i) {
        to.row(i) = curve.point(i / 20.0);
    }
    const Points deformed = 2 * curve.controlPoints().array().cos();
    const Points mapped = NearestElementMapping(interface, to).apply(deformed);
    const geometry::NurbsCurve deformedCurve = curve.withControlPoints(deformed);
    for (int i = 0; i < 21; ++i) {
        EXPECT_LT((mapped.row(i).transpose() - deformedCurve.point(i / 20.0)).norm(), 1e-13);
    }
}

TEST(NearestElementMapping, reports_what_it_found) {
    const SplineInterface interface = flapInterface();
    Points to = flapPoints(20);
    to(7, 0) -= 0.004;
    const MappingReport report = NearestElementMapping(interface, to).report();
    EXPECT_EQ(report.nPoints, 60);
    EXPECT_EQ(report.nUnmatched, 0);
    EXPECT_EQ(report.nAmbiguous, 0);
    EXPECT_EQ(report.coverage, 1);
    EXPECT_EQ(report.worstPoint, 7);
    EXPECT_NEAR(report.largestGap, 0.004, 1e-15);
    EXPECT_NEAR(report.relativeGap, 0.004 / std::hypot(0.1, 1), 1e-15);
    EXPECT_LT(report.rowSumError, 1e-14);
    EXPECT_LT(report.forceSumError, 1e-14);
    EXPECT_GT(report.momentError, 1e-6) << "the gap's moment is lost and must be told";
    EXPECT_GT(report.bytes, 0);
    for (const char* word : {"nearest element", "points 60", "100.0 %", "0.004", "point 7"}) {
        EXPECT_NE(report.text().find(word), std::string::npos) << word << report.text();
    }
}

TEST(NearestElementMapping, moment_that_it_loses_is_that_of_the_forces_over_their_gaps) {
    // All forces go to the origin, in the middle of two points.
    Points to(2, 3);
    to << 0.1, 0, 0, -0.1, 0, 0;
    const MappingReport report =
        NearestElementMapping(PointCloud(Points::Zero(1, 3)), to, {1, false}).report();
    const Points forces = probeForces(2);
    const double total = forces.rowwise().norm().sum();
    EXPECT_NEAR(report.momentError, moment(to, forces).norm() / (0.1 * total), 1e-14);
    EXPECT_LT(report.forceSumError, 1e-15);
}

namespace {

/// A value that counts by nine tenths only.
class Leaky : public Discretisation {
  public:
    int nValues() const override { return 1; }
    const Points& coordinates() const override { return origin_; }
    double size() const override { return 1; }
    Location locate(const Point&) const override {
        return {{{0}, Eigen::VectorXd::Constant(1, 0.9)}, 0, true, false};
    }

  private:
    Points origin_ = Points::Zero(1, 3);
};

} // namespace

TEST(NearestElementMapping, error_of_a_constant_is_told) {
    const MappingReport report = NearestElementMapping(Leaky(), Points::Zero(2, 3)).report();
    EXPECT_NEAR(report.rowSumError, 0.1, 1e-15);
}

TEST(NearestElementMapping, refuses_a_gap_and_names_point_gap_and_limit) {
    const SplineInterface interface = flapInterface();
    Points to = flapPoints(20);
    to.row(33) += Eigen::RowVector3d(0, 0.25, 0);
    expectInputError([&] { NearestElementMapping(interface, to, {0.05}); },
                     {"point 33", "0.25 m", "0.249", "limit is 0.05", "1 of 60"});
    const NearestElementMapping mapping(interface, to, {0.05, false});
    EXPECT_EQ(mapping.report().nUnmatched, 1);
    EXPECT_NEAR(mapping.report().coverage, 59.0 / 60, 1e-15);
}

TEST(NearestElementMapping, refuses_points_that_are_not_finite_and_an_empty_interface) {
    const SplineInterface interface = flapInterface();
    Points to = flapPoints(4);
    to(5, 1) = NAN;
    expectInputError([&] { NearestElementMapping(interface, to); }, {"point 5", "nan"});
    expectInputError([&] { NearestElementMapping(interface, Points(0, 3)); }, {"no point"});
}

TEST(NearestElementMapping, scale_position_and_rotation_do_not_matter) {
    const SplineInterface interface = quarterCircle(2, 6);
    const geometry::NurbsCurve& curve = interface.pieces()[0].curve;
    Points to(33, 3);
    for (int i = 0; i < 33; ++i) {
        to.row(i) = (1 + 0.003 * std::sin(i)) * curve.point(i / 32.0);
    }
    const Eigen::MatrixXd reference = NearestElementMapping(interface, to).matrix().toDense();
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(1.1, Point(1, 2, -1).normalized()).toRotationMatrix();
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 1e6}) {
            const auto moved = [&](const Points& x) -> Points {
                return (scale * x * rotation.transpose()).rowwise() +
                       scale * offset * Eigen::RowVector3d(1, -0.3, 0.2);
            };
            const SplineInterface other({{curve.withControlPoints(moved(curve.controlPoints())),
                                          interface.pieces()[0].controlPoints, "arc"}},
                                        curve.nControlPoints());
            const Eigen::MatrixXd matrix =
                NearestElementMapping(other, moved(to)).matrix().toDense();
            // Coordinates of size 1e6 carry 1e-10; the functions' slopes are about 10.
            EXPECT_LT((matrix - reference).cwiseAbs().maxCoeff(), offset > 0 ? 1e-8 : 1e-12)
                << "scale " << scale << ", offset " << offset;
        }
    }
}

} // namespace tokay::mapper
