// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/timeIntegration/SubsteppedIntegrator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

namespace {

/// The example's flap, with a force on its unknowns that a fluid would give.
struct Flap {
    explicit Flap(const std::string& strains = "linear", const std::string& traction = "0")
        : structureCase(readText(text(strains, traction))), body(makeBody(structureCase)) {
        shape = VectorXd::Zero(body->model().nUnknowns());
        for (int k = 0; k < shape.size(); k += 2) {
            shape[k] = body->model().fixed()[static_cast<std::size_t>(k)] ? 0 : 10; // N along x
        }
    }
    // Loads of its own that began all at once would excite all modes
    static std::string text(const std::string& strains, const std::string& traction) {
        std::string text = exampleText("100*y", traction);
        return text.replace(text.find("strains: linear"), 15, "strains: " + strains);
    }
    SubsteppedIntegrator integrator(int nSubsteps) {
        return {body->model(), *structureCase.implicitScheme(), NewtonOptions{1e-12, 25, true, 0.1},
                0, nSubsteps};
    }
    VectorXd force(double time) const { return (1 - std::cos(40 * time)) * shape; }

    Case structureCase;
    std::unique_ptr<Body> body;
    VectorXd shape;
};

constexpr double endTime = 0.12;

/// Displacement at the end of so many steps of the fluid.
VectorXd advance(Flap& flap, SubsteppedIntegrator& integrator, int nSteps) {
    for (int step = 1; step <= nSteps; ++step) {
        const double time = step * endTime / nSteps;
        integrator.beginTimeStep(time, endTime / nSteps);
        integrator.solve(flap.force(time));
        integrator.acceptTimeStep();
    }
    return integrator.state().displacement;
}

VectorXd advance(Flap& flap, int nSteps, int nSubsteps) {
    SubsteppedIntegrator integrator = flap.integrator(nSubsteps);
    return advance(flap, integrator, nSteps);
}

void expectNear(const VectorXd& a, const VectorXd& b, double tolerance) {
    EXPECT_LE((a - b).norm(), tolerance * b.norm());
}

} // namespace

class Substeps : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Strains, Substeps, testing::Values("linear", "nonlinear"));

TEST_P(Substeps, one_is_the_step_itself) {
    Flap flap(GetParam());
    TimeIntegrator whole(flap.body->model(), *flap.structureCase.implicitScheme(),
                         NewtonOptions{1e-12, 25, true, 0.1}, 0);
    for (int step = 1; step <= 5; ++step) {
        const double time = step * endTime / 5;
        whole.beginTimeStep(time, endTime / 5);
        whole.solve(flap.force(time));
        whole.acceptTimeStep();
    }
    EXPECT_EQ(advance(flap, 5, 1), whole.state().displacement);
}

TEST_P(Substeps, under_a_constant_force_are_as_many_steps) {
    Flap flap(GetParam());
    SubsteppedIntegrator few = flap.integrator(4);
    SubsteppedIntegrator many = flap.integrator(1);
    MotionState start = few.state();
    start.force = flap.shape; // not that at rest, from which it would rise within a step
    few.restore(start, {});
    many.restore(start, {});
    for (int step = 1; step <= 20; ++step) {
        const double time = step * endTime / 20;
        many.beginTimeStep(time, endTime / 20);
        many.solve(flap.shape);
        many.acceptTimeStep();
        if (step % 4 == 0) {
            few.beginTimeStep(time, endTime / 5);
            few.solve(flap.shape);
            few.acceptTimeStep();
        }
    }
    // Times of the substeps differ by rounding, which the factor 1/step^2 of inertia magnifies
    expectNear(few.state().displacement, many.state().displacement, 1e-9);
    expectNear(few.state().velocity, many.state().velocity, 1e-8);
    EXPECT_NEAR(few.energies().externalWork, many.energies().externalWork,
                1e-8 * many.energies().externalWork);
}

TEST(SubstepsOfLinearFlap, count_as_work_what_the_structure_gains) {
    Flap flap;
    flap.structureCase.timeScheme = TimeScheme::generalisedAlpha(1); // keeps energy
    SubsteppedIntegrator integrator = flap.integrator(3);
    double work = 0;
    for (int step = 1; step <= 20; ++step) {
        const double time = step * endTime / 20;
        const MotionState before = integrator.state();
        integrator.beginTimeStep(time, endTime / 20);
        integrator.solve(flap.force(time));
        integrator.acceptTimeStep();
        const MotionState& after = integrator.state();
        EXPECT_EQ(after.time, time);
        // The force between steps is the true one; halving differences rounds
        expectNear(after.force, flap.force(time), 1e-14);
        work += 0.5 * (before.force + after.force).dot(after.displacement - before.displacement);
    }
    const Energies& energies = integrator.energies();
    ASSERT_GT(energies.strain, 0);
    // Rounding errors of 60 steps
    EXPECT_NEAR(energies.externalWork, energies.kinetic + energies.strain, 1e-9 * energies.strain);
    EXPECT_NEAR(energies.externalWork, work, 1e-9 * energies.strain);
}

TEST_P(Substeps, take_the_structures_own_loads_at_their_own_times) {
    Flap flap(GetParam(), "1000*sin(50*t)");
    SubsteppedIntegrator few = flap.integrator(4);
    TimeIntegrator many(flap.body->model(), *flap.structureCase.implicitScheme(),
                        NewtonOptions{1e-12, 25, true, 0.1}, 0);
    const VectorXd none = VectorXd::Zero(flap.shape.size());
    for (int step = 1; step <= 5; ++step) {
        few.beginTimeStep(0.02 * step, 0.02);
        few.solve(none);
        few.acceptTimeStep();
        for (int part = 4 * step - 3; part <= 4 * step; ++part) {
            many.beginTimeStep(0.005 * part, 0.005);
            many.solve();
            many.acceptTimeStep();
        }
    }
    // Times of the substeps differ by rounding, which the factor 1/step^2 of inertia magnifies
    expectNear(few.state().displacement, many.state().displacement, 1e-9);
    EXPECT_NEAR(few.energies().externalWork, many.energies().externalWork,
                1e-8 * std::abs(many.energies().externalWork));
}

TEST_P(Substeps, keep_the_second_order) {
    Flap flap(GetParam());
    const VectorXd coarse = advance(flap, 48, 3);
    const VectorXd middle = advance(flap, 96, 3);
    const VectorXd fine = advance(flap, 192, 3);
    const double order = std::log2((coarse - middle).norm() / (middle - fine).norm());
    // 63 steps of the fluid in a period of the force, and 188 of the structure: higher
    // orders and modes are small beside the second
    EXPECT_NEAR(order, 2, 0.15);
}

TEST_P(Substeps, count_with_the_last_force_alone) {
    Flap flap(GetParam());
    SubsteppedIntegrator once = flap.integrator(3);
    SubsteppedIntegrator often = flap.integrator(3);
    for (int step = 1; step <= 5; ++step) {
        const double time = step * endTime / 5;
        once.beginTimeStep(time, endTime / 5);
        once.solve(flap.force(time));
        once.acceptTimeStep();
        often.beginTimeStep(time, endTime / 5);
        often.solve(-2 * flap.force(time));
        EXPECT_EQ(often.state().time, (step - 1) * endTime / 5);
        often.solve(1.1 * flap.force(time));
        often.solve(flap.force(time));
        often.acceptTimeStep();
    }
    // Newton's method ends at 1e-12 of the forces
    expectNear(often.state().displacement, once.state().displacement, 1e-9);
    EXPECT_NEAR(often.energies().externalWork, once.energies().externalWork,
                1e-8 * once.energies().externalWork);
}

TEST_P(Substeps, leave_no_trace_of_a_rejected_step) {
    Flap flap(GetParam());
    SubsteppedIntegrator integrator = flap.integrator(3);
    advance(flap, integrator, 5);
    integrator.dropTangent();
    const MotionState before = integrator.state();
    const Energies energies = integrator.energies();
    integrator.beginTimeStep(2 * endTime, endTime);
    integrator.solve(flap.force(2 * endTime));
    integrator.rejectTimeStep();
    EXPECT_EQ(integrator.state().displacement, before.displacement);
    EXPECT_EQ(integrator.state().velocity, before.velocity);
    EXPECT_EQ(integrator.state().time, before.time);
    EXPECT_EQ(integrator.energies().externalWork, energies.externalWork);

    SubsteppedIntegrator straight = flap.integrator(3);
    advance(flap, straight, 5);
    straight.dropTangent();
    for (SubsteppedIntegrator* each : {&integrator, &straight}) {
        each->beginTimeStep(1.1 * endTime, 0.1 * endTime);
        each->solve(flap.force(1.1 * endTime));
        each->acceptTimeStep();
    }
    EXPECT_EQ(integrator.state().displacement, straight.state().displacement);
}

TEST_P(Substeps, single_step_that_is_rejected_is_forgotten) {
    Flap flap(GetParam());
    SubsteppedIntegrator integrator = flap.integrator(1);
    advance(flap, integrator, 3);
    const VectorXd before = integrator.state().displacement;
    integrator.beginTimeStep(2 * endTime, endTime);
    integrator.solve(flap.force(2 * endTime));
    ASSERT_NE(integrator.displacement(), before);
    integrator.rejectTimeStep();
    EXPECT_EQ(integrator.displacement(), before);
    EXPECT_EQ(integrator.state().displacement, before);
}

TEST(SubstepsOfLinearFlap, count_one_iteration_each) {
    Flap flap;
    for (const int nSubsteps : {1, 3, 4}) {
        SubsteppedIntegrator integrator = flap.integrator(nSubsteps);
        integrator.beginTimeStep(endTime, endTime);
        integrator.solve(flap.force(endTime));
        integrator.solve(flap.force(endTime)); // counts anew
        EXPECT_EQ(integrator.nIterations(), nSubsteps);
    }
}

namespace {

/// A fluid that a push starts: it resists a motion of all the structure's mass along x
/// with its acceleration at the end of the step, as OpenFOAM's scheme backward has it.
class AddedMass {
  public:
    AddedMass(const Flap& flap, double ratio) {
        VectorXd along = VectorXd::Zero(flap.shape.size());
        for (int k = 0; k < along.size(); k += 2) {
            along[k] = flap.shape[k] == 0 ? 0 : 1;
        }
        direction_ = flap.body->model().massMatrix() * along;
        mass_ = ratio / along.dot(direction_);
    }

    /// Takes a step in which the structure and the fluid agree.
    /// @return the motion of all mass along x
    double advance(SubsteppedIntegrator& integrator, double deltaT) {
        const double time = integrator.state().time + deltaT;
        integrator.beginTimeStep(time, deltaT);
        const double push = time < 4 * deltaT ? 1 : 0;
        // The structure is linear, so two forces tell the one in balance
        const auto outOfBalance = [&](double force) {
            const VectorXd& displacement = integrator.solve(force * direction_);
            return force - push + mass_ * acceleration(direction_.dot(displacement), deltaT);
        };
        const double without = outOfBalance(0);
        const double slope = outOfBalance(1) - without;
        integrator.solve(-without / slope * direction_);
        integrator.acceptTimeStep();
        const double motion = direction_.dot(integrator.state().displacement);
        for (int k = 3; k > 0; --k) {
            old_[k] = old_[k - 1];
        }
        old_[0] = motion;
        return motion;
    }

  private:
    double acceleration(double motion, double deltaT) const {
        const auto rate = [&](double a, double b, double c) {
            return (1.5 * a - 2 * b + 0.5 * c) / deltaT;
        };
        return rate(rate(motion, old_[0], old_[1]), rate(old_[0], old_[1], old_[2]),
                    rate(old_[1], old_[2], old_[3]));
    }

    VectorXd direction_;
    double mass_;
    double old_[4] = {};
};

} // namespace

// A force that is linear in time within the step multiplies an error by -2 in each:
// 10^18 in these
TEST(SubstepsOfLinearFlap, are_stable_with_ten_times_the_mass_added) {
    for (const TimeScheme& scheme :
         {TimeScheme::generalisedAlpha(1), TimeScheme::generalisedAlpha(0.8),
          TimeScheme::generalisedAlpha(0), TimeScheme::newmark(0.25, 0.5)}) {
        for (const int nSubsteps : {2, 4, 16}) {
            SCOPED_TRACE(nSubsteps);
            Flap flap;
            flap.structureCase.timeScheme = scheme;
            SubsteppedIntegrator integrator = flap.integrator(nSubsteps);
            SubsteppedIntegrator single = flap.integrator(1);
            AddedMass fluid(flap, 10);
            AddedMass sameFluid(flap, 10);
            double largest = 0;
            double difference = 0;
            for (int step = 0; step < 60; ++step) {
                const double motion = fluid.advance(integrator, 0.01);
                const double expected = sameFluid.advance(single, 0.01);
                largest = std::max(largest, std::abs(expected));
                difference = std::max(difference, std::abs(motion - expected));
            }
            // Errors of the single step in time: 6e-4 at the largest
            EXPECT_LE(difference, 2e-3 * largest) << scheme.alphaF;
        }
    }
}

TEST(SubstepsOfNonlinearFlap, begin_their_iterations_where_the_last_solution_ended) {
    Flap flap("nonlinear");
    SubsteppedIntegrator integrator = flap.integrator(3);
    integrator.beginTimeStep(endTime, endTime);
    integrator.solve(flap.force(endTime));
    EXPECT_GE(integrator.nIterations(), 2 * 3); // nonlinear in each of the three
    integrator.solve(flap.force(endTime));
    EXPECT_EQ(integrator.nIterations(), 0);
}
