// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "coupling/couplingMethods.hpp"
#include "coupling/step/ConvergenceCriteria.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

const double tolerance = 1e-6;
const double automaticLimit = 10 * tolerance;

const VectorXd atRest = VectorXd::Ones(2); // x and x̃ of a structure that has converged

ConvergenceOptions withoutForce() {
    ConvergenceOptions options;
    options.force = ForceCriterion::none;
    return options;
}

VectorXd forceOf(double size) {
    return VectorXd::Constant(3, size);
}

/// Criteria of a run whose forces had this size in its first steps.
ConvergenceCriteria afterSteps(double size) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    for (int step = 0; step < 10; ++step) {
        criteria.beginTimeStep();
        criteria.acceptTimeStep(forceOf(size));
    }
    criteria.beginTimeStep();
    return criteria;
}

/// Of the change of a force within a step, the structure having converged.
double residualOfChange(ConvergenceCriteria& criteria, double from, double to) {
    criteria.beginTimeStep();
    criteria.residual(atRest, atRest, forceOf(from));
    return criteria.residual(atRest, atRest, forceOf(to));
}

TEST(ConvergenceCriteria, residual_is_relative_to_the_displacement) {
    ConvergenceCriteria criteria(withoutForce(), tolerance);
    const VectorXd x = VectorXd::Constant(7, 3);
    EXPECT_NEAR(criteria.residual(x, 1.01 * x, {}), 0.01 / 1.01, 1e-14);
    EXPECT_NEAR(criteria.residual(1e-9 * x, 1.01e-9 * x, {}), 0.01 / 1.01, 1e-14);
}

TEST(ConvergenceCriteria, a_structure_at_rest_has_converged) {
    ConvergenceCriteria criteria(withoutForce(), tolerance);
    EXPECT_EQ(criteria.residual(VectorXd::Zero(2), VectorXd::Zero(2), {}), 0);
    EXPECT_EQ(criteria.residual(VectorXd::Zero(2), VectorXd::Ones(2), {}), 1);
    EXPECT_EQ(criteria.residual(VectorXd::Ones(2), VectorXd::Zero(2), {}), 1);
}

TEST(ConvergenceCriteria, absolute_floor_is_reached_exactly_at_the_tolerance) {
    ConvergenceOptions options = withoutForce();
    options.absoluteDisplacement = 1e-3;
    ConvergenceCriteria criteria(options, tolerance);
    const auto residualOf = [&](double difference) {
        return criteria.residual(VectorXd::Zero(5), VectorXd::Constant(5, difference), {});
    };
    EXPECT_LT(residualOf(0.99e-3), tolerance);
    EXPECT_GT(residualOf(1.01e-3), tolerance);
}

TEST(ConvergenceCriteria, force_must_hold_still_to_a_limit_that_is_given) {
    ConvergenceOptions options;
    options.relativeForce = 1e-3;
    ConvergenceCriteria criteria(options, tolerance);
    criteria.beginTimeStep();
    EXPECT_GT(criteria.residual(atRest, atRest, forceOf(10)), tolerance) << "nothing to compare";
    EXPECT_LT(criteria.residual(atRest, atRest, forceOf(10.009)), tolerance);
    EXPECT_GT(criteria.residual(atRest, atRest, forceOf(10.030), 0.1 * tolerance), tolerance)
        << "whatever the fluid's residual";
    criteria.beginTimeStep();
    EXPECT_GT(criteria.residual(atRest, atRest, forceOf(10.030)), tolerance)
        << "forces of another step do not count";
}

TEST(ConvergenceCriteria,
     force_must_hold_still_to_ten_tolerances_by_default_or_to_one_that_is_loose) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    EXPECT_LT(residualOfChange(criteria, 10, 10 * (1 + 0.9 * automaticLimit)), tolerance);
    EXPECT_GT(residualOfChange(criteria, 10, 10 * (1 + 1.1 * automaticLimit)), tolerance);
    ConvergenceCriteria loose(ConvergenceOptions(), 5e-3);
    EXPECT_LT(residualOfChange(loose, 10, 10 * (1 + 0.9 * 5e-3)), 5e-3);
    EXPECT_GT(residualOfChange(loose, 10, 10 * (1 + 1.1 * 5e-3)), 5e-3);
    ConvergenceCriteria between(ConvergenceOptions(), 5e-4);
    EXPECT_LT(residualOfChange(between, 10, 10 * (1 + 0.9e-3)), 5e-4);
    EXPECT_GT(residualOfChange(between, 10, 10 * (1 + 1.1e-3)), 5e-4);
}

TEST(ConvergenceCriteria, absolute_force_is_reached_exactly_at_the_tolerance) {
    ConvergenceOptions options;
    options.absoluteForce = 1e-3;
    ConvergenceCriteria criteria(options, tolerance);
    EXPECT_LT(residualOfChange(criteria, 1, 1 + 0.99e-3), tolerance);
    EXPECT_GT(residualOfChange(criteria, 1, 1 + 1.01e-3), tolerance);
}

TEST(ConvergenceCriteria, residual_is_the_displacements_where_there_is_no_force_to_compare) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    criteria.beginTimeStep();
    EXPECT_NEAR(criteria.residual(atRest, 1.01 * atRest, forceOf(1)), 0.01 / 1.01, 1e-14);
}

TEST(ConvergenceCriteria, the_default_is_met_where_the_flow_has_converged) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    criteria.beginTimeStep();
    EXPECT_LT(criteria.residual(atRest, atRest, forceOf(1), 0.9 * tolerance), tolerance);
    EXPECT_GT(criteria.residual(atRest, atRest, forceOf(2), 1.1 * tolerance), tolerance);
    EXPECT_LT(criteria.residual(atRest, atRest, forceOf(3), 0.9 * tolerance), tolerance);
}

TEST(ConvergenceCriteria, a_flow_has_not_converged_at_a_loose_tolerance_alone) {
    constexpr double loose = 5e-3;
    ConvergenceCriteria criteria(ConvergenceOptions(), loose);
    criteria.beginTimeStep();
    EXPECT_GT(criteria.residual(atRest, atRest, forceOf(1), 0.9 * loose), loose);
    EXPECT_GT(criteria.residual(atRest, atRest, forceOf(2), 1.1e-4), loose);
    EXPECT_LT(criteria.residual(atRest, atRest, forceOf(3), 0.9e-4), loose);
}

TEST(ConvergenceCriteria, a_fluid_at_rest_blocks_no_step) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    EXPECT_EQ(residualOfChange(criteria, 0, 0), 0);
    criteria.beginTimeStep();
    EXPECT_EQ(criteria.residual(atRest, atRest, forceOf(0), 0), 0) << "nor costs an iteration";
}

TEST(ConvergenceCriteria, a_force_may_be_of_any_size) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    EXPECT_LT(residualOfChange(criteria, 1e-30, 1e-30 * (1 + 0.9 * automaticLimit)), tolerance);
    EXPECT_GT(residualOfChange(criteria, 1e-30, 1e-30 * (1 + 1.1 * automaticLimit)), tolerance);
}

TEST(ConvergenceCriteria, noise_of_a_force_that_has_faded_blocks_no_step) {
    ConvergenceCriteria criteria = afterSteps(10);
    EXPECT_LT(residualOfChange(criteria, 9e-5, 0), tolerance); // of 10 N
    EXPECT_GT(residualOfChange(criteria, 11e-5, 0), tolerance);
    ConvergenceCriteria unlearned(ConvergenceOptions(), tolerance);
    EXPECT_GT(residualOfChange(unlearned, 9e-5, 0), tolerance);
}

TEST(ConvergenceCriteria, a_force_is_compared_with_its_mean_over_all_steps) {
    ConvergenceCriteria criteria(ConvergenceOptions(), tolerance);
    for (const double size : {12, 6, 0}) { // 6 on average
        criteria.acceptTimeStep(forceOf(size));
    }
    EXPECT_LT(residualOfChange(criteria, 0.9 * 6 * automaticLimit, 0), tolerance);
    EXPECT_GT(residualOfChange(criteria, 1.1 * 6 * automaticLimit, 0), tolerance);
}

TEST(ConvergenceCriteria, the_mean_force_survives_a_restart) {
    ConvergenceCriteria criteria = afterSteps(10);
    std::vector<std::uint8_t> bytes;
    StateWriter write(bytes);
    criteria.save(write);
    StateReader read(bytes);
    ConvergenceCriteria restored(ConvergenceOptions(), tolerance);
    restored.restore(read);
    EXPECT_EQ(read.remaining(), 0u);
    restored.acceptTimeStep(forceOf(3));
    criteria.acceptTimeStep(forceOf(3));
    EXPECT_EQ(residualOfChange(restored, 1, 2), residualOfChange(criteria, 1, 2));
}

/// A mass so large that within a step of 1e-3 s no force moves it by the tolerance.
class HeavyMass : public CoupledStructure {
  public:
    VectorXd acceptedDisplacements() const override { return VectorXd::Constant(1, x_); }
    VectorXd solve(const VectorXd& force) override {
        newVelocity_ = velocity_ + deltaT * force[0] / mass; // implicit Euler
        return VectorXd::Constant(1, x_ + deltaT * newVelocity_);
    }
    void acceptTimeStep() {
        velocity_ = newVelocity_;
        x_ += deltaT * velocity_;
    }
    double position() const { return x_; }

    static constexpr double deltaT = 1e-3; // [s]
    static constexpr double mass = 1e4;    // [kg]

  private:
    double x_ = 1; // [m]
    double velocity_ = 0;
    double newVelocity_ = 0;
};

/// How far the mass goes in a thousand steps under 1 N, over how far it should, if the fluid
/// halves the error of its force in each coupling iteration, from no force on.
double relativeDistance(const ConvergenceOptions& convergence) {
    CouplingOptions options;
    options.acceleration.type = "aitken";
    options.convergence = convergence;
    HeavyMass mass;
    const auto method = makeCouplingMethod(options, 1e-4, mass);
    constexpr int nSteps = 1000;
    for (int step = 0; step < nSteps; ++step) {
        method->predict(HeavyMass::deltaT);
        double force = 0;
        bool converged = false;
        for (int i = 0; i < 100 && !converged; ++i) {
            force += (1 - force) / 2;
            converged = method->iterate(VectorXd::Constant(1, force), std::nullopt).converged;
        }
        EXPECT_TRUE(converged);
        method->accept(VectorXd::Constant(1, force));
        mass.acceptTimeStep();
    }
    const double distance =
        std::pow(HeavyMass::deltaT, 2) / HeavyMass::mass * nSteps * (nSteps + 1) / 2;
    return (mass.position() - 1) / distance;
}

TEST(ConvergenceCriteria, a_heavy_structure_moves_by_the_force_of_a_flow_that_has_converged) {
    EXPECT_NEAR(relativeDistance(withoutForce()), 0.5, 1e-6) << "the displacement is blind";
    // A last change of 1e-3 is as much again as all further ones.
    EXPECT_NEAR(relativeDistance(ConvergenceOptions()), 1, 1e-3);
}

TEST(ConvergenceCriteria, tolerance_out_of_its_range_is_refused) {
    for (const double wrong : {0.0, -1e-4, 1.1, std::nan("")}) {
        EXPECT_THROW(ConvergenceCriteria(ConvergenceOptions(), wrong), InputError) << wrong;
    }
    EXPECT_NO_THROW(ConvergenceCriteria(ConvergenceOptions(), 1)) << "nothing has to converge";
}

} // namespace
} // namespace tokay::coupling
