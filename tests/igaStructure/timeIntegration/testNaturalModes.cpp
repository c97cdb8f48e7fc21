// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/kinematics/solid/exampleSolid.hpp"
#include "igaStructure/run/ResultsLock.hpp"
#include "igaStructure/run/runModes.hpp"
#include "igaStructure/tableRows.hpp"
#include "igaStructure/timeIntegration/Springs.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"
#include "temporaryDirectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using testing::HasSubstr;

TEST(NaturalModes, cantilever_has_the_frequencies_of_euler_and_bernoulli) {
    ExampleBeam kind;
    kind.strains = Strains::linear;
    kind.elements = 32;
    const NaturalModes modes = naturalModes(kind.build(), 4);
    const double roots[] = {1.875104069, 4.694091133, 7.854757438, 10.99554073};
    for (int k = 0; k < 4; ++k) {
        const double exact = std::pow(roots[k] / 10, 2) *
                             std::sqrt(kind.section().bendingStiffness / kind.section().mass);
        EXPECT_NEAR(modes.angularFrequencies[k], exact, 1e-6 * exact); // degree 4, 32 elements
    }
}

TEST(NaturalModes, shapes_are_orthogonal_and_of_modal_mass_one) {
    const PlaneSolid solid = makeExample({Kinematics::planeStrain, Strains::nonlinear, true});
    const NaturalModes modes = naturalModes(solid, 6);
    const MatrixXd product = modes.shapes.transpose() * (solid.massMatrix() * modes.shapes);
    EXPECT_LT((product - MatrixXd::Identity(6, 6)).norm(), 1e-9); // as the iteration's tolerance
    for (int k = 0; k < 6; ++k) {
        for (int i = 0; i < solid.nUnknowns(); ++i) {
            if (solid.fixed()[i]) {
                EXPECT_EQ(modes.shapes(i, k), 0);
            }
        }
    }
}

TEST(NaturalModes, free_body_has_three_rigid_modes) {
    const PlaneSolid solid(geometry::refine(geometry::rectangle({0, 0, 0}, 0.1, 1), 2, 3, 2, 8),
                           exampleMaterial(Kinematics::planeStrain), Strains::linear, {}, {});
    const NaturalModes modes = naturalModes(solid, 4);
    // Rounding of squares: a rigid mode's is the last digits of the highest one.
    for (int k = 0; k < 3; ++k) {
        EXPECT_LT(modes.angularFrequencies[k], 1e-2 * modes.angularFrequencies[3]);
    }
    const double free = std::pow(4.730040745, 2) * std::sqrt(4e6 / 0.91 * 1e-3 / 12 / 300);
    // A solid of slenderness 10 bends and shears: a few percent below the beam.
    EXPECT_NEAR(modes.angularFrequencies[3], free, 0.05 * free);
    EXPECT_LT(modes.angularFrequencies[3], free);
}

// An elastic ring in plane strain, radii 0.95 and 1.05, ovalling (n = 2): a
// quarter with symmetric edges. Published: 2.555042 rad/s (solids4foam, ringAddedMass).
TEST(NaturalModes, ring_ovals_with_the_published_frequency) {
    PlaneMaterial material;
    material.youngsModulus = 1e6;
    material.poissonsRatio = 0.3;
    material.density = 1000;
    const PlaneSolid ring(
        geometry::refine(geometry::ringSector({0, 0, 0}, 0.95, 1.05, 0, 0.5 * M_PI), 3, 4, 2, 12),
        material, Strains::linear,
        {{geometry::Edge::bottom, {false, true}}, {geometry::Edge::top, {true, false}}}, {});
    EXPECT_NEAR(naturalModes(ring, 1).angularFrequencies[0], 2.555042, 0.0005 * 2.555042);
}

TEST(NaturalModes, more_modes_than_unknowns_are_refused) {
    ExampleBeam kind;
    kind.degree = 2;
    kind.elements = 1;
    EXPECT_THROW(naturalModes(kind.build(), 3), InputError);
}

TEST(RunModes, prints_and_tabulates_frequencies_and_writes_shapes) {
    const TemporaryDirectory directory;
    std::string log;
    runModes(readCase(directory.write("case.yaml", exampleText())), 3,
             [&](const std::string& line) { log += line + "\n"; });
    EXPECT_THAT(log, HasSubstr("mode 3  "));
    const auto rows = tableRows(directory.read("postProcessing/case/modes.dat"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NEAR(rows[1][1], 2 * M_PI * rows[1][2], 1e-9 * rows[1][1]);
    EXPECT_THAT(directory.read("results/caseModes.pvd"), HasSubstr("timestep=\"3\""));
}

TEST(RunModes, a_second_one_that_would_write_the_same_results_is_refused) {
    const TemporaryDirectory directory;
    const Report silent = [](const std::string&) {};
    const ResultsLock first(directory.file("results"), "caseModes", silent);
    EXPECT_THROW(runModes(readCase(directory.write("case.yaml", exampleText())), 1, silent),
                 InputError);
}

TEST(NaturalModes, frequencies_that_several_modes_share_are_found_as_often_as_they_occur) {
    // Three springs of each of the lowest stiffnesses, far below the others. From one start
    // Lanczos' method sees one mode of each but for rounding.
    constexpr int n = 60;
    Springs springs(
        n, [](double u) { return u; }, [](double) { return 1; });
    springs.mass = 4;
    springs.factor = [](int k) { return k % 10 == 0 ? 1 + k / 30 : 1e3 + k; };
    for (int count = 1; count <= 6; ++count) {
        const NaturalModes modes = naturalModes(springs, count);
        const MatrixXd product = modes.shapes.transpose() * (springs.massMatrix() * modes.shapes);
        // The iteration's tolerance.
        EXPECT_LT((product - MatrixXd::Identity(count, count)).norm(), 1e-9);
        for (int k = 0; k < count; ++k) {
            const double stiffness = 1 + k / 3;
            EXPECT_NEAR(modes.angularFrequencies[k], std::sqrt(stiffness / 4), 1e-9) << k;
            for (int i = 0; i < n; ++i) {
                if (springs.factor(i) != stiffness) {
                    EXPECT_NEAR(modes.shapes(i, k), 0, 1e-7) << i << " of mode " << k;
                }
            }
        }
    }
}

TEST(NaturalModes, frequencies_that_modes_share_are_found_beside_close_ones_too) {
    // Where the next frequencies are close, one search ends before rounding shows all modes
    // of a frequency: it takes modes of the next one for them.
    for (const int nShared : {3, 4, 8}) {
        Springs springs(
            60, [](double u) { return u; }, [](double) { return 1; });
        springs.factor = [&](int k) { return 1 + 0.01 * (k / nShared); };
        for (const int count : {2, 4, 6, 8, 10}) {
            const NaturalModes modes = naturalModes(springs, count);
            for (int k = 0; k < count; ++k) {
                EXPECT_NEAR(modes.angularFrequencies[k], std::sqrt(springs.factor(k)), 1e-9)
                    << k << " of " << count << ", " << nShared << " share one";
            }
        }
    }
}

TEST(NaturalModes, as_many_as_unknowns_are_refused_and_one_less_is_found) {
    Springs springs(
        4, [](double u) { return u; }, [](double) { return 1; });
    springs.factor = [](int k) { return 1.0 + k; };
    EXPECT_THROW(naturalModes(springs, 4), InputError);
    EXPECT_NEAR(naturalModes(springs, 3).angularFrequencies[2], std::sqrt(3), 1e-9);
}
