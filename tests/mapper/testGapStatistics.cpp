// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/sampleGeometry.hpp"
#include "mapper/GapStatistics.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/samplePatches.hpp"

#include <gtest/gtest.h>

namespace tokay::mapper {

namespace {

/// One value at the origin. Projections fail left of it, and are ambiguous above it.
class Origin : public Discretisation {
  public:
    int nValues() const override { return 1; }
    const Points& coordinates() const override { return origin_; }
    double size() const override { return 1; }
    Location locate(const Point& point) const override {
        return {{{0}, Eigen::VectorXd::Ones(1)}, point.norm(), point[0] >= 0, point[1] > 0};
    }

  private:
    Points origin_ = Points::Zero(1, 3);
};

} // namespace

TEST(GapStatistics, points_whose_projection_fails_are_unmatched_and_ambiguous_ones_are_counted) {
    Points to(4, 3);
    to << 0.1, 0, 0, -0.1, 0, 0, 0.1, 0.1, 0, -0.1, 0.1, 0;
    const MappingReport report = NearestElementMapping(Origin(), to, {0.5}).report();
    EXPECT_EQ(report.nUnmatched, 2);
    EXPECT_EQ(report.nAmbiguous, 2);
    EXPECT_EQ(report.coverage, 0.5);
}

TEST(GapStatistics, points_whose_place_newtons_method_does_not_meet_are_unmatched) {
    const SplineInterface onCurve({{geometry::parabola(), {0, 1, 2}, "parabola"}}, 3);
    const SurfaceInterface onSurface =
        onePatch(geometry::TrimmedPatch(geometry::parabolicCylinder()));
    const SurfaceInterface onRim = onePatch(geometry::plateBelowParabola());
    Points to(3, 3); // the second one is its vertex's centre of curvature
    to << 0, 0.4, 0, 0, 0.5, 0, 0.1, 0.4, 0;
    for (const Discretisation* from :
         std::initializer_list<const Discretisation*>{&onCurve, &onSurface, &onRim}) {
        const MappingReport report = NearestElementMapping(*from, to, {0.5}).report();
        EXPECT_EQ(report.nUnmatched, 1);
        EXPECT_NEAR(report.coverage, 2.0 / 3, 1e-15);
    }
}

TEST(GapStatistics, the_first_of_the_farthest_points_is_the_worst) {
    GapStatistics gaps({0.5, true}, 2);
    const double distances[] = {0.1, 0.4, 0.2, 0.4};
    for (const double distance : distances) {
        gaps.count(Point(distance, 0, 0), distance, true, false);
    }
    MappingReport report;
    gaps.enter(report);
    EXPECT_EQ(report.worstPoint, 1);
    EXPECT_EQ(report.largestGap, 0.4);
    EXPECT_EQ(report.relativeGap, 0.2);
}

TEST(GapStatistics, coverage_is_the_matched_part_of_what_the_points_stand_for) {
    GapStatistics gaps({0.1, false}, 1);
    EXPECT_TRUE(gaps.count(Point::Zero(), 0.1, true, false, 3));
    EXPECT_FALSE(gaps.count(Point::Zero(), 0.2, true, false, 2));
    gaps.countUncovered(5);
    MappingReport report;
    gaps.enter(report);
    EXPECT_EQ(report.coverage, 0.3);
}

TEST(GapStatistics, gap_at_the_limit_is_matched_and_not_refused) {
    GapStatistics gaps({0.25, true}, 2);
    EXPECT_TRUE(gaps.count(Point::Zero(), 0.5, true, false));
    MappingReport report;
    EXPECT_NO_THROW(gaps.enter(report));
    EXPECT_EQ(report.nUnmatched, 0);
}

TEST(GapStatistics, of_nothing_covers_nothing) {
    MappingReport report;
    GapStatistics({0.25, true}, 2).enter(report);
    EXPECT_EQ(report.coverage, 0);
    EXPECT_EQ(report.worstPoint, -1);
}

TEST(GapStatistics, points_are_refused_where_products_of_them_would_overflow) {
    Points points = Points::Zero(2, 3);
    points(1, 2) = -1e50;
    EXPECT_NO_THROW(checkPoints(points));
    points(1, 2) = -1.01e50;
    expectInputError([&] { checkPoints(points); }, {"point 1", "1e+50"});
}

} // namespace tokay::mapper
