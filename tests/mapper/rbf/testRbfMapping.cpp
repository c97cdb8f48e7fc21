// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "mapper/conservation.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/rbf/RbfMapping.hpp"
#include "mapper/sampleInterfaces.hpp"
#include "mapper/sampleMeshes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tokay::mapper {

namespace {

const RadialKernel allKernels[] = {RadialKernel::thinPlate, RadialKernel::compactC2,
                                   RadialKernel::compactC4, RadialKernel::compactC6};

Points cloud(int nX, int nY, int seed) {
    return flatMesh(nX, nY, FaceKind::triangles, ValuesAt::vertices, 2, 1, seed).coordinates();
}

/// The flat cloud bent onto a cylinder: points in space.
Points bent(const Points& flat) {
    Points points(flat.rows(), 3);
    for (Eigen::Index i = 0; i < flat.rows(); ++i) {
        points.row(i) << std::cos(flat(i, 0)), std::sin(flat(i, 0)), flat(i, 1);
    }
    return points;
}

RbfOptions with(RadialKernel kernel) {
    RbfOptions options;
    options.kernel = kernel;
    return options;
}

} // namespace

TEST(RbfMapping, takes_linear_fields_exactly_and_conserves_force_and_moment) {
    const Points line = verticalMesh(12).coordinates(), otherLine = verticalMesh(17).coordinates();
    const std::pair<Points, Points> pairs[] = {{cloud(9, 7, 0), cloud(6, 8, 2)},
                                               {bent(cloud(9, 7, 0)), bent(cloud(6, 8, 2))},
                                               {line, otherLine}};
    for (const RadialKernel kernel : allKernels) {
        for (const auto& [from, to] : pairs) {
            const RbfMapping mapping(from, to, with(kernel));
            const Points expected = linearField(to);
            // The kernel matrix's condition, 1e4 to 1e6, enlarges rounding.
            EXPECT_LT((mapping.apply(linearField(from)) - expected).cwiseAbs().maxCoeff(), 1e-10);
            const Points forces = probeForces(to.rows());
            const Points mapped = mapping.applyTransposed(forces);
            EXPECT_LT((mapped.colwise().sum() - forces.colwise().sum()).norm(),
                      1e-10 * forces.norm());
            EXPECT_LT(mapping.report().momentError, 1e-10);
            const Points values = probeForces(from.rows()).array().cos();
            EXPECT_NEAR(mapping.apply(values).cwiseProduct(forces).sum(),
                        values.cwiseProduct(mapped).sum(), 1e-11 * values.norm() * mapped.norm());
        }
    }
}

TEST(RbfMapping, passes_through_the_values_of_the_source) {
    const Points from = bent(cloud(9, 7, 0)), values = probeForces(from.rows());
    for (const RadialKernel kernel : allKernels) {
        EXPECT_LT((RbfMapping(from, from, with(kernel)).apply(values) - values).norm(), 1e-9);
    }
}

TEST(RbfMapping, errors_of_a_smooth_field_fall_with_the_spacing_at_a_fixed_radius) {
    const Points to = cloud(13, 9, 4);
    const auto smooth = [](const Points& x) -> Eigen::VectorXd {
        return (2 * x.col(0)).array().sin() * (3 * x.col(1)).array().cos();
    };
    for (const RadialKernel kernel : allKernels) {
        double previous = 1;
        for (const int n : {6, 12, 24}) {
            const Points from = cloud(2 * n, n, 0);
            RbfOptions options = with(kernel);
            options.radius = 1;
            const double error = (RbfMapping(from, to, options).apply(smooth(from)) - smooth(to))
                                     .cwiseAbs()
                                     .maxCoeff();
            // The least order is the thin plate's, 2 up to the boundary: a factor of 4.
            EXPECT_LT(error, previous / (n == 6 ? 10 : 3)) << nameOf(kernel) << " " << n;
            previous = error;
        }
    }
}

TEST(RbfMapping, scale_position_and_rotation_do_not_matter) {
    const Points from = bent(cloud(9, 7, 0)), to = bent(cloud(6, 8, 2));
    const Points values = probeForces(from.rows());
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(1.1, Point(1, 2, -1).normalized()).toRotationMatrix();
    for (const RadialKernel kernel : allKernels) {
        const Points reference = RbfMapping(from, to, with(kernel)).apply(values);
        for (const double scale : {1e-6, 1e6}) {
            const auto moved = [&](const Points& x) -> Points {
                return (scale * x * rotation.transpose()).rowwise() +
                       scale * Eigen::RowVector3d(10, -3, 2);
            };
            const Points mapped = RbfMapping(moved(from), moved(to), with(kernel)).apply(values);
            EXPECT_LT((mapped - reference).cwiseAbs().maxCoeff(), 1e-9);
        }
    }
}

TEST(RbfMapping, rotation_does_not_matter_for_the_partition_of_unity_of_a_large_cloud) {
    const Points from = bent(cloud(40, 20, 0)), to = bent(cloud(31, 18, 2));
    const Points values = probeForces(from.rows());
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.7, Point(-1, 2, 1).normalized()).toRotationMatrix();
    for (const RadialKernel kernel : allKernels) {
        const RbfMapping reference(from, to, with(kernel)),
            turned(from * rotation.transpose(), to * rotation.transpose(), with(kernel));
        ASSERT_NE(reference.report().method.find("partition"), std::string::npos);
        // The kernel matrix's condition enlarges rounding.
        EXPECT_LT((turned.apply(values) - reference.apply(values)).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST(RbfMapping, the_automatic_radius_holds_the_neighbours_of_every_point) {
    const Points from = cloud(20, 10, 0);
    RbfOptions options = with(RadialKernel::compactC2);
    options.nNeighbours = 15;
    const double radius = RbfMapping(from, from, options).radius();
    Eigen::Index fewest = from.rows();
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
        fewest = std::min(fewest, ((from.rowwise() - from.row(i)).rowwise().norm().array() <=
                                   radius * (1 + 1e-12))
                                      .count());
    }
    EXPECT_EQ(fewest, 16); // itself and 15
}

TEST(RbfMapping, the_partition_of_unity_takes_linear_fields_and_conserves_force_and_moment) {
    const Points line = verticalMesh(300).coordinates(),
                 otherLine = verticalMesh(170).coordinates();
    const std::pair<Points, Points> pairs[] = {{cloud(40, 20, 0), cloud(31, 18, 2)},
                                               {bent(cloud(40, 20, 0)), bent(cloud(31, 18, 2))},
                                               {line, otherLine}};
    for (const RadialKernel kernel : allKernels) {
        for (const auto& [from, to] : pairs) {
            RbfOptions options = with(kernel);
            options.solution = RbfSolution::partitionOfUnity;
            const RbfMapping mapping(from, to, options);
            // The fitted polynomial takes all of them: no kernel adds its rounding.
            EXPECT_LT((mapping.apply(linearField(from)) - linearField(to)).cwiseAbs().maxCoeff(),
                      1e-12);
            EXPECT_LT(mapping.report().rowSumError, 1e-12);
            expectForceAndMomentConserved(mapping, probeForces(to.rows()), from, to);
            expectTransposesEqual(mapping, static_cast<int>(from.rows()),
                                  static_cast<int>(to.rows()));
        }
    }
}

TEST(RbfMapping, the_partition_of_unity_is_about_as_good_as_the_global_solution) {
    const Points from = bent(cloud(44, 22, 0)), to = bent(cloud(61, 30, 3));
    const auto smooth = [](const Points& x) -> Eigen::VectorXd {
        return (2 * x.col(0)).array().sin() * (3 * x.col(2)).array().cos();
    };
    const auto errorBy = [&](RbfSolution solution) {
        RbfOptions options;
        options.solution = solution;
        return (RbfMapping(from, to, options).apply(smooth(from)) - smooth(to)).norm();
    };
    const double global = errorBy(RbfSolution::global);
    EXPECT_LT(global, 0.05);
    EXPECT_LT(errorBy(RbfSolution::partitionOfUnity), 1.5 * global);
}

TEST(RbfMapping, a_hundred_thousand_points_are_mapped_by_the_partition_of_unity_in_little_memory) {
    const Points from = bent(cloud(446, 224, 0)), to = bent(cloud(300, 300, 3));
    ASSERT_GT(from.rows(), 100000);
    const RbfMapping mapping(from, to);
    EXPECT_NE(mapping.report().method.find("partition of unity"), std::string::npos);
    EXPECT_LT(mapping.report().bytes, 3e8); // a dense matrix would be 8e10
    const Eigen::VectorXd values = (2 * from.col(0)).array().sin() * from.col(2).array().cos();
    const Eigen::VectorXd exact = (2 * to.col(0)).array().sin() * to.col(2).array().cos();
    // Spacing 0.0045: linear interpolation would leave its square, 2e-5.
    EXPECT_LT((mapping.apply(values) - exact).cwiseAbs().maxCoeff(), 2e-5);
}

TEST(RbfMapping, solves_the_thin_plate_globally_for_few_source_points_within_the_bound_of_memory) {
    const RbfOptions options;
    EXPECT_EQ(chosenSolution(options, 300, 1000), RbfSolution::global);
    EXPECT_EQ(chosenSolution(options, 301, 1000), RbfSolution::partitionOfUnity);
    EXPECT_EQ(chosenSolution(options, 250, 500000), RbfSolution::global); // 1.0 GB
    EXPECT_EQ(chosenSolution(options, 250, 500001), RbfSolution::partitionOfUnity);
    RbfOptions asked;
    asked.solution = RbfSolution::global;
    EXPECT_EQ(chosenSolution(asked, 250, 500001), RbfSolution::global);
    const Points from = cloud(30, 20, 0), few = cloud(15, 10, 0), to = cloud(25, 30, 3);
    EXPECT_NE(RbfMapping(from, to).report().method.find("partition"), std::string::npos);
    EXPECT_EQ(RbfMapping(few, to).report().method.find("partition"), std::string::npos);
}

TEST(RbfMapping, solves_compact_kernels_globally_only_if_their_number_of_neighbours_is_given) {
    for (const RadialKernel kernel : {RadialKernel::compactC2, RadialKernel::compactC6}) {
        RbfOptions options = with(kernel);
        EXPECT_EQ(chosenSolution(options, 20, 20), RbfSolution::partitionOfUnity);
        options.radius = 0.3;
        EXPECT_EQ(chosenSolution(options, 20, 20), RbfSolution::partitionOfUnity);
        options.radius = 0;
        options.nNeighbours = 20;
        EXPECT_EQ(chosenSolution(options, 20, 20), RbfSolution::global);
    }
}

TEST(RbfMapping, the_partition_of_unity_takes_the_radius_of_a_compact_kernel) {
    const auto smooth = [](const Points& x) -> Eigen::VectorXd {
        return (4 * x.col(0)).array().sin() * (3 * x.col(1)).array().cos();
    };
    const Points from = cloud(48, 24, 0), to = cloud(37, 19, 3);
    const auto errorWithin = [&](RadialKernel kernel, double radius) {
        RbfOptions options = with(kernel);
        options.radius = radius;
        const RbfMapping mapping(from, to, options);
        EXPECT_EQ(mapping.radius(), radius);
        EXPECT_NE(mapping.report().method.find("partition"), std::string::npos);
        return (mapping.apply(smooth(from)) - smooth(to)).norm();
    };
    // Spacing 0.042. The wider the kernel the smaller the error, the more the smoother it is.
    for (const RadialKernel kernel :
         {RadialKernel::compactC2, RadialKernel::compactC4, RadialKernel::compactC6}) {
        EXPECT_LT(errorWithin(kernel, 1), 0.5 * errorWithin(kernel, 0.2)) << nameOf(kernel);
    }
    EXPECT_LT(errorWithin(RadialKernel::compactC6, 1),
              0.5 * errorWithin(RadialKernel::compactC2, 1));
}

TEST(RbfMapping, the_automatic_choice_is_about_as_accurate_as_the_better_solution) {
    const auto smooth = [](const Points& x) -> Eigen::VectorXd {
        return (2 * x.col(0)).array().sin() * (3 * x.col(2)).array().cos();
    };
    const Points to = bent(cloud(37, 19, 3));
    for (const RadialKernel kernel : allKernels) {
        for (const int n : {6, 12, 18, 30}) {
            const Points from = bent(cloud(2 * n, n, 0));
            const auto errorBy = [&](RbfSolution solution) {
                RbfOptions options = with(kernel);
                options.solution = solution;
                return (RbfMapping(from, to, options).apply(smooth(from)) - smooth(to)).norm();
            };
            const double best =
                std::min(errorBy(RbfSolution::global), errorBy(RbfSolution::partitionOfUnity));
            // Near the bounds the two are alike.
            EXPECT_LT(errorBy(RbfSolution::automatic), 1.5 * best) << nameOf(kernel) << ' ' << n;
        }
    }
}

TEST(RbfMapping, maps_from_a_few_points_with_every_kernel) {
    const Points to = cloud(5, 4, 1);
    for (const RadialKernel kernel : allKernels) {
        for (const int n : {1, 2, 3}) {
            const Points from = cloud(2, 1, 0).topRows(n);
            RbfOptions options = with(kernel);
            options.gapLimit.relative = 1e3; // of the few points' size
            options.gapLimit.refuse = false;
            const RbfMapping mapping(from, to, options);
            EXPECT_LT(mapping.report().rowSumError, 1e-12) << nameOf(kernel) << ' ' << n;
        }
    }
}

TEST(RbfMapping, refuses_coinciding_points_too_many_points_and_far_ones) {
    Points from = cloud(4, 4, 0);
    from.row(7) = from.row(3);
    expectInputError([&] { RbfMapping(from, from); }, {"point 3", "coincides"});
    const Points many = cloud(90, 90, 0), far = cloud(2, 2, 0).array() + 9;
    RbfOptions global;
    global.solution = RbfSolution::global;
    expectInputError([&] { RbfMapping(many, many.topRows(5), global); },
                     {"8281", "8000", "partition of unity", "compactC2"});
    const Points fine = cloud(300, 300, 1);
    expectInputError([&] { RbfMapping(cloud(40, 40, 0), fine, global); },
                     {"90601", "1681", "1.22 GB", "limit is 1 GB", "partition of unity"});
    expectInputError([&] { RbfMapping(cloud(4, 4, 0), far); }, {"do not lie on each other"});
    expectInputError([] { radialKernelFromName("gauss"); }, {"gauss", "thinPlate"});
}

namespace {

/// Distance of the point from which the k-th neighbour is farthest.
double farthestNeighbour(const Points& points, int k) {
    double farthest = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        std::vector<double> distances;
        for (Eigen::Index j = 0; j < points.rows(); ++j) {
            distances.push_back((points.row(j) - points.row(i)).norm());
        }
        std::sort(distances.begin(), distances.end()); // the first is the point itself
        farthest = std::max(farthest, distances[static_cast<std::size_t>(k)]);
    }
    return farthest;
}

/// nX x nY x nZ points, 1 apart.
Points grid(int nX, int nY, int nZ) {
    Points points(nX * nY * nZ, 3);
    for (int i = 0; i < nX * nY * nZ; ++i) {
        points.row(i) << i % nX, i / nX % nY, i / (nX * nY);
    }
    return points;
}

double radiusOf(const Points& points, RbfOptions options) {
    options.solution = RbfSolution::global;
    return RbfMapping(points, points, options).radius();
}

} // namespace

TEST(RbfMapping, radius_of_compact_kernels_reaches_the_neighbours_of_the_loneliest_point) {
    Points points(5, 3);
    points << 10, 0, 0, 3, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0, 0;
    RbfOptions options = with(RadialKernel::compactC2);
    options.nNeighbours = 1;
    EXPECT_EQ(radiusOf(points, options), 7);
    options.nNeighbours = 2;
    EXPECT_EQ(radiusOf(points, options), 8);
    options.radius = 5; // as it is given
    EXPECT_EQ(radiusOf(points, options), 5);
}

TEST(RbfMapping, compact_kernels_have_so_many_neighbours_on_curves_surfaces_and_in_space) {
    const RbfOptions options = with(RadialKernel::compactC2);
    for (const auto& [points, nNeighbours] :
         {std::pair{grid(20, 1, 1), 12}, {grid(10, 9, 1), 40}, {grid(6, 5, 5), 80}}) {
        EXPECT_NEAR(radiusOf(points, options), farthestNeighbour(points, nNeighbours), 1e-12);
    }
}

TEST(RbfMapping, source_points_that_coincide_to_rounding_are_refused) {
    Points points = grid(4, 3, 1);
    points.row(7) = points.row(2);
    points(7, 0) += 1e-13;
    expectInputError([&] { RbfMapping(points, points); }, {"point", "coincides"});
}

TEST(RbfMapping, memory_of_the_partition_of_unity_is_that_of_its_blocks_at_least) {
    const Points points = grid(20, 20, 1);
    RbfOptions options;
    options.solution = RbfSolution::partitionOfUnity;
    // Each point lies in a ball at least, of 60 source points.
    EXPECT_GE(RbfMapping(points, points, options).report().bytes, 400 * 60 * sizeof(double));
}

} // namespace tokay::mapper
