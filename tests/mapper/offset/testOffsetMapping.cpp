// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/conservation.hpp"
#include "mapper/offset/LinearisedMapping.hpp"
#include "mapper/offset/OffsetMapping.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tokay::mapper {

namespace {

std::vector<int> consecutive(int n) {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// A rational, curved axis: an arc of radius 1.
SplineInterface beam() {
    const geometry::NurbsCurve axis = refine(geometry::arc(Point::Zero(), 1, 0, 1.2), 3, 6);
    const int n = axis.nControlPoints();
    return SplineInterface({{axis, consecutive(n), "beam"}}, n);
}

/// Both sides of a beam of thickness 0.04, and its end faces.
Points aroundBeam() {
    Points points(52, 3);
    for (int i = 0; i < 24; ++i) {
        const double angle = 1.2 * (i + 0.5) / 24;
        points.row(2 * i) << 0.98 * std::cos(angle), 0.98 * std::sin(angle), 0;
        points.row(2 * i + 1) << 1.02 * std::cos(angle), 1.02 * std::sin(angle), 0;
    }
    points.row(48) << 0.99, -0.003, 0; // beyond the end at (1, 0)
    points.row(49) << 1.01, -0.003, 0;
    points.row(50) << 1, 0, 0;
    points.row(51) << std::cos(1.2), std::sin(1.2), 0;
    return points;
}

SurfaceInterface shell() {
    const geometry::NurbsSurface surface =
        refine(geometry::cylinderPatch(Point::Zero(), 1, 1, 0.1, 1.4), 2, 3, 4, 3);
    const int n = surface.nControlPoints();
    return SurfaceInterface({{geometry::TrimmedPatch(surface), consecutive(n), "shell"}}, n);
}

Points aroundShell(int n = 60) {
    Points points(n, 3);
    for (int i = 0; i < n; ++i) {
        // Beyond the edges too: angles from 0.08 and heights from -0.02.
        const double angle = 0.08 + 1.34 * std::fmod(0.37 * i, 1);
        const double radius = 1 + 0.03 * std::sin(i);
        points.row(i) << radius * std::cos(angle), radius * std::sin(angle),
            -0.02 + 1.04 * std::fmod(0.61 * i, 1);
    }
    return points;
}

/// Large, smooth, without symmetry; in the plane for the beam.
Points deformation(const Points& x, bool isPlane) {
    Points u(x.rows(), 3);
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        u.row(i) << 0.3 * std::sin(2 * x(i, 1)), 0.4 * x(i, 0) * x(i, 0) + 0.1 * x(i, 2),
            isPlane ? 0 : 0.2 * std::cos(3 * x(i, 0));
    }
    return u;
}

Points forcesOn(Eigen::Index n, bool isPlane) {
    Points forces = probeForces(n);
    if (isPlane) {
        forces.col(2).setZero();
    }
    return forces;
}

Point moment(const Points& x, const Points& f) {
    Point sum = Point::Zero();
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        sum += Point(x.row(i)).cross(Point(f.row(i)));
    }
    return sum;
}

struct Scene {
    Points controlPoints, points;
    OffsetMapping mapping;
    bool isPlane;
};

std::vector<Scene> scenes() {
    const SplineInterface axis = beam();
    const SurfaceInterface middle = shell();
    return {{axis.coordinates(), aroundBeam(), OffsetMapping(axis, aroundBeam()), true},
            {middle.coordinates(), aroundShell(), OffsetMapping(middle, aroundShell()), false}};
}

} // namespace

TEST(OffsetMapping, finds_the_distances_with_their_sides) {
    const Eigen::VectorXd offsets = OffsetMapping(beam(), aroundBeam()).offsets();
    for (int i = 0; i < 24; ++i) {
        // Left of a counter-clockwise arc lies its centre.
        EXPECT_NEAR(offsets[2 * i], 0.02, 1e-13);
        EXPECT_NEAR(offsets[2 * i + 1], -0.02, 1e-13);
    }
    EXPECT_NEAR(offsets[48], 0.01, 1e-13);
    EXPECT_NEAR(offsets[50], 0, 1e-14);
}

TEST(OffsetMapping, points_follow_finite_rigid_motions_exactly) {
    for (const Scene& scene : scenes()) {
        const Point axis =
            scene.isPlane ? Point(Point::UnitZ()) : Point(Point(1, -2, 3).normalized());
        const Eigen::Matrix3d rotation = Eigen::AngleAxisd(2.1, axis).toRotationMatrix();
        const auto displacement = [&](const Points& x) -> Points {
            return (x * rotation.transpose() - x).rowwise() + Eigen::RowVector3d(3, -1, 0);
        };
        EXPECT_LT(
            (scene.mapping.moved(displacement(scene.controlPoints)) - displacement(scene.points))
                .cwiseAbs()
                .maxCoeff(),
            1e-13);
    }
}

TEST(OffsetMapping, the_variation_is_the_derivative_of_the_motion) {
    for (const Scene& scene : scenes()) {
        const Points state = deformation(scene.controlPoints, scene.isPlane);
        const Points direction = forcesOn(state.rows(), scene.isPlane);
        const double h = 1e-6; // error h^2 and 1e-16 / h
        const Points difference = (scene.mapping.moved(state + h * direction) -
                                   scene.mapping.moved(state - h * direction)) /
                                  (2 * h);
        const Points exact = scene.mapping.variation(state, direction);
        EXPECT_LT((difference - exact).norm(), 1e-8 * exact.norm());
    }
}

TEST(OffsetMapping, virtual_work_is_conserved_in_any_state) {
    for (const Scene& scene : scenes()) {
        for (const double size : {0.0, 1.0}) {
            const Points state = size * deformation(scene.controlPoints, scene.isPlane);
            const Points variation = probeForces(state.rows());
            const Points forces = probeForces(scene.points.rows()).array().cos();
            const Points moved = scene.mapping.variation(state, variation);
            const Points mapped = scene.mapping.forces(state, forces);
            EXPECT_NEAR(moved.cwiseProduct(forces).sum(), variation.cwiseProduct(mapped).sum(),
                        1e-12 * moved.norm() * forces.norm());
        }
    }
}

TEST(OffsetMapping, force_and_moment_arrive_in_the_deformed_state) {
    for (const Scene& scene : scenes()) {
        const Points state = deformation(scene.controlPoints, scene.isPlane);
        const Points forces = forcesOn(scene.points.rows(), scene.isPlane);
        const Points mapped = scene.mapping.forces(state, forces);
        const Points positions = scene.points + scene.mapping.moved(state);
        const double total = forces.rowwise().norm().sum();
        EXPECT_LT((mapped.colwise().sum() - forces.colwise().sum()).norm(), 1e-12 * total);
        EXPECT_LT((moment(scene.controlPoints + state, mapped) - moment(positions, forces)).norm(),
                  1e-12 * total);
    }
}

TEST(OffsetMapping, linearised_it_is_its_derivative_at_rest_at_any_displacement) {
    for (const Scene& scene : scenes()) {
        const LinearisedMapping linear(scene.mapping);
        const Points rest = Points::Zero(scene.controlPoints.rows(), 3);
        const Points state = deformation(scene.controlPoints, scene.isPlane);
        const Points variation = probeForces(state.rows());
        const Points forces = probeForces(scene.points.rows()).array().cos();
        const Points moved = scene.mapping.variation(rest, variation);
        const Points mapped = scene.mapping.forces(rest, forces);
        // The same sums in another order
        EXPECT_LT((linear.moved(variation) - moved).norm(), 1e-13 * moved.norm());
        EXPECT_LT((linear.variation(state, variation) - moved).norm(), 1e-13 * moved.norm());
        EXPECT_LT((linear.forces(state, forces) - mapped).norm(), 1e-13 * mapped.norm());
    }
}

TEST(OffsetMapping, linearised_to_faces_it_spreads_a_force_over_their_points) {
    for (const Scene& scene : scenes()) {
        const Eigen::Index nPoints = scene.points.rows(), nFaces = 5;
        RowSparseMatrix shares(nPoints, nFaces);
        for (Eigen::Index i = 0; i < nPoints; ++i) {
            shares.insert(i, i % nFaces) = 0.1 + 0.01 * static_cast<double>(i);
        }
        const LinearisedMapping linear(scene.mapping, shares);
        const Points onFaces = probeForces(nFaces);
        const Points rest = Points::Zero(scene.controlPoints.rows(), 3);
        const Points mapped = scene.mapping.forces(rest, shares * onFaces);
        EXPECT_LT((linear.forces(rest, onFaces) - mapped).norm(), 1e-13 * mapped.norm());
    }
}

TEST(OffsetMapping, maps_many_points_at_once_as_it_maps_few) {
    constexpr int n = 20000, few = 4000; // so many that threads share them, and so few that not
    const SurfaceInterface middle = shell();
    const Points points = aroundShell(n), state = deformation(middle.coordinates(), false);
    const Points variation = probeForces(state.rows()), forces = probeForces(n);
    const OffsetMapping mapping(middle, points);
    const Points moved = mapping.moved(state), varied = mapping.variation(state, variation);
    Points sum = Points::Zero(state.rows(), 3);
    for (int i = 0; i < n; i += few) {
        const OffsetMapping part(middle, points.middleRows(i, few));
        EXPECT_EQ(moved.middleRows(i, few), part.moved(state));
        EXPECT_EQ(varied.middleRows(i, few), part.variation(state, variation));
        sum += part.forces(state, forces.middleRows(i, few));
    }
    const Points mapped = mapping.forces(state, forces);
    // The same sums in another order, then in the same order
    EXPECT_LT((mapped - sum).norm(), 1e-13 * mapped.norm());
    EXPECT_EQ(mapped, mapping.forces(state, forces));
}

TEST(OffsetMapping, reports_conservation_and_refuses_points_too_far_away) {
    for (const Scene& scene : scenes()) {
        EXPECT_LT(scene.mapping.report().rowSumError, 1e-13);
        EXPECT_LT(scene.mapping.report().forceSumError, 1e-13);
        EXPECT_LT(scene.mapping.report().momentError, 1e-13);
    }
    EXPECT_NEAR(OffsetMapping(beam(), aroundBeam()).report().largestGap, 0.02, 1e-12);
    Points far = aroundBeam();
    far(3, 0) += 1;
    expectInputError([&] { OffsetMapping(beam(), far); }, {"point 3", "limit is 0.1"});
}

TEST(OffsetMapping, refuses_a_beam_out_of_its_plane) {
    const geometry::NurbsCurve axis = geometry::line(Point::Zero(), Point(1, 0, 0.2));
    const SplineInterface interface({{axis, {0, 1}, "mast"}}, 2);
    expectInputError([&] { OffsetMapping(interface, Points::Zero(1, 3)); }, {"mast", "0.2"});
}

TEST(OffsetMapping, takes_a_beam_that_is_in_its_plane_to_rounding) {
    const auto interface = [](double height) {
        const geometry::NurbsCurve axis = geometry::line(Point::Zero(), Point(1, 0, height));
        return SplineInterface({{axis, {0, 1}, "mast"}}, 2);
    };
    EXPECT_NO_THROW(OffsetMapping(interface(1e-10), Points::Zero(1, 3)));
    expectInputError([&] { OffsetMapping(interface(1e-8), Points::Zero(1, 3)); }, {"1e-08"});
}

TEST(OffsetMapping, refuses_a_point_over_a_pole) {
    const geometry::NurbsSurface dome = geometry::sphere(Point::Zero(), 1);
    const int n = dome.nControlPoints();
    const SurfaceInterface interface({{geometry::TrimmedPatch(dome), consecutive(n), "dome"}}, n);
    Points to(1, 3);
    to << 0, 0, 1.01;
    expectInputError([&] { OffsetMapping(interface, to); }, {"(0, 0, 1.01)", "pole"});
}

TEST(OffsetMapping, moves_nothing_if_nothing_moves_nor_out_of_a_beams_plane) {
    for (const Scene& scene : scenes()) {
        const Points rest = Points::Zero(scene.controlPoints.rows(), 3);
        EXPECT_EQ(scene.mapping.moved(rest), Points::Zero(scene.points.rows(), 3));
    }
    Points to = aroundBeam();
    to.col(2).setConstant(0.01); // beside the plane
    const OffsetMapping beside(beam(), to), within(beam(), aroundBeam());
    const Points state = deformation(beam().coordinates(), true);
    EXPECT_LT((beside.moved(state) - within.moved(state)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(OffsetMapping, numbers_of_control_points_do_not_matter) {
    const Points state = deformation(beam().coordinates(), true);
    const int nBeam = static_cast<int>(state.rows());
    std::vector<int> reversed = consecutive(nBeam);
    std::reverse(reversed.begin(), reversed.end());
    const SplineInterface axis({{beam().pieces()[0].curve, reversed, "beam"}}, nBeam);
    EXPECT_EQ(OffsetMapping(axis, aroundBeam()).moved(state.colwise().reverse()),
              OffsetMapping(beam(), aroundBeam()).moved(state));
    const Points bent = deformation(shell().coordinates(), false);
    const int nShell = static_cast<int>(bent.rows());
    reversed = consecutive(nShell);
    std::reverse(reversed.begin(), reversed.end());
    const SurfaceInterface middle({{shell().piece(0).patch, reversed, "shell"}}, nShell);
    EXPECT_EQ(OffsetMapping(middle, aroundShell()).moved(bent.colwise().reverse()),
              OffsetMapping(shell(), aroundShell()).moved(bent));
}

TEST(OffsetMapping, points_as_near_to_all_of_an_arc_are_counted_as_ambiguous) {
    Points to(2, 3);
    to << 0, 0, 0, 0.9, 0.1, 0; // the centre, and another point
    const GapLimit wide{2, false};
    EXPECT_EQ(OffsetMapping(beam(), to, wide).report().nAmbiguous, 1);
    to.col(2).setConstant(0.5); // on the cylinder's axis
    EXPECT_EQ(OffsetMapping(shell(), to, wide).report().nAmbiguous, 1);
}

} // namespace tokay::mapper
