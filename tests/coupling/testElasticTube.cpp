// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic tube of 10 cells, κ = 10, τ = 0.01: a fluid and a structure that
// cannot be coupled by plain iteration, against their monolithic solution.
#include "ElasticTube.hpp"
#include "coupling/couplingMethods.hpp"
#include "coupling/fixedPoint/IqnIls.hpp"
#include "coupling/fixedPoint/Mvqn.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

constexpr int nCells = 10;
constexpr int nSteps = 100;
constexpr double tolerance = 1e-7;

struct Result {
    double meanIterations = 0;
    double largestError = 0; ///< of x against the monolithic solution, relative
};

/// Runs all steps; each starts from the accepted partitioned solution.
Result runTube(const CouplingOptions& options) {
    ElasticTube tube(nCells, 10, 0.01);
    const auto method = makeCouplingMethod(options, tolerance, tube);
    Result result;
    for (int step = 0; step < nSteps; ++step) {
        tube.beginTimeStep();
        ElasticTube reference = tube;
        const VectorXd exact = reference.monolithic(VectorXd::Zero(nCells));
        VectorXd x = method->predict(tube.deltaT());
        VectorXd forces;
        for (int i = 0; i < 100; ++i) {
            forces = tube.fluid(x);
            const CouplingIteration iteration = method->iterate(forces, 0);
            if (iteration.converged) {
                break;
            }
            x = iteration.x;
        }
        EXPECT_TRUE(method->statistics().converged) << "step " << step;
        result.largestError = std::max(result.largestError, (x - exact).norm() / exact.norm());
        result.meanIterations += method->statistics().nIterations / double(nSteps);
        method->accept(forces);
        tube.acceptTimeStep(x);
    }
    return result;
}

/// Published upper limits of an implementation of another house (FOAM-FSI,
/// test_broydenpostprocessing) with the same extrapolation and tolerance.
TEST(ElasticTube,
     iqn_ils_needs_no_more_iterations_than_published_and_finds_the_monolithic_solution) {
    const struct {
        int reusedTimeSteps;
        double publishedLimit;
    } cases[] = {{0, 10.7}, {1, 7.0}, {4, 5.8}, {8, 5.3}};
    for (const auto& [reusedTimeSteps, publishedLimit] : cases) {
        CouplingOptions options;
        options.acceleration.type = "iqnIls";
        options.predictor = Extrapolation::quadratic;
        auto& iqnIls = options.acceleration.of<IqnIls::Options>();
        iqnIls.reusedTimeSteps = reusedTimeSteps;
        iqnIls.keepFraction = 0; // this fluid has no drift to guard against
        const Result result = runTube(options);
        std::printf(
            "reuse %d: %.2f coupling iterations per step (published at most %.1f), error %.1e\n",
            reusedTimeSteps, result.meanIterations, publishedLimit, result.largestError);
        EXPECT_LE(result.meanIterations, publishedLimit) << "reuse " << reusedTimeSteps;
        // The error is the residual through (1 - S'F')^-1, here of norm one.
        EXPECT_LT(result.largestError, 2 * tolerance);
    }
}

/// Carrying the Jacobian over needs no more than the best of the published
/// limits, those of eight reused steps, and its cost does not grow with time.
TEST(ElasticTube, mvqn_does_at_least_as_well_with_a_bounded_rank) {
    CouplingOptions options;
    options.acceleration.type = "mvqn";
    options.predictor = Extrapolation::quadratic;
    auto& mvqn = options.acceleration.of<Mvqn::Options>();
    mvqn.keepFraction = 0;
    mvqn.maxRank = 20; // restarts with ten, the number of unknowns
    const Result result = runTube(options);
    std::printf("MVQN: %.2f coupling iterations per step, error %.1e\n", result.meanIterations,
                result.largestError);
    EXPECT_LE(result.meanIterations, 5.3);
    EXPECT_LT(result.largestError, 2 * tolerance);
}

TEST(ElasticTube, aitken_finds_the_monolithic_solution_too) {
    CouplingOptions options;
    options.acceleration.type = "aitken";
    const Result result = runTube(options);
    std::printf("Aitken: %.2f coupling iterations per step, error %.1e\n", result.meanIterations,
                result.largestError);
    EXPECT_LT(result.largestError, 2 * tolerance);
}

TEST(ElasticTube, explicit_coupling_diverges) {
    CouplingOptions options;
    options.acceleration.type = "explicit";
    ElasticTube tube(nCells, 10, 0.01);
    const auto method = makeCouplingMethod(options, tolerance, tube);
    const auto run = [&] {
        for (int step = 0; step < nSteps; ++step) {
            tube.beginTimeStep();
            const VectorXd x = method->predict(tube.deltaT());
            method->accept(tube.fluid(x));
            tube.acceptTimeStep(x);
        }
    };
    EXPECT_ANY_THROW(run());
}

} // namespace
} // namespace tokay::coupling
