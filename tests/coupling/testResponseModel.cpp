// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/ResponseModel.hpp"

#include <gtest/gtest.h>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int n = 6;

ResponseOptions withoutLeastNoise() {
    ResponseOptions options;
    options.filterLimit = 0;
    return options;
}

double error(const ResponseModel& model, const MatrixXd& J) {
    return (model.matrix().A() * model.matrix().B().transpose() - J).norm() / J.norm();
}

TEST(ResponseModel, is_exact_after_as_many_independent_differences_as_there_are_directions) {
    std::srand(3);
    const MatrixXd J = MatrixXd::Random(4, n);
    ResponseModel model(withoutLeastNoise());
    model.beginTimeStep();
    EXPECT_TRUE(model.isEmpty());
    for (int k = 0; k < n; ++k) {
        const VectorXd v = VectorXd::Random(n);
        model.learn(v, J * v, 0);
        EXPECT_LT((model.matrix().apply(v, 4) - J * v).norm(), 1e-10 * J.norm());
    }
    EXPECT_LT(error(model, J), 1e-10); // condition of the differences: some 1e2
}

TEST(ResponseModel, keeps_in_a_step_what_the_step_has_taught_and_corrects_earlier_steps) {
    std::srand(4);
    const MatrixXd before = MatrixXd::Random(n, n);
    const MatrixXd now = MatrixXd::Random(n, n);
    ResponseModel model(withoutLeastNoise());
    model.beginTimeStep();
    for (int k = 0; k < n; ++k) {
        model.learn(VectorXd::Unit(n, k), before.col(k), 0);
    }
    model.acceptTimeStep();
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 0), now.col(0), 0);
    model.learn(VectorXd::Unit(n, 0) + VectorXd::Unit(n, 1), now.col(0) + now.col(1), 0);
    MatrixXd expected = before;
    expected.leftCols(2) = now.leftCols(2);
    EXPECT_LT(error(model, expected), 1e-13);
}

TEST(ResponseModel, a_difference_within_its_noise_changes_little) {
    const VectorXd v = VectorXd::Unit(n, 2);
    const VectorXd w = VectorXd::Ones(n);
    const auto learned = [&](double noise) {
        ResponseModel model(withoutLeastNoise());
        model.beginTimeStep();
        model.learn(v, w, noise);
        return model.matrix().apply(v, n)[0];
    };
    EXPECT_DOUBLE_EQ(learned(0), 1);
    EXPECT_DOUBLE_EQ(learned(1), 0.5); // 1 / (1 + 1)
    EXPECT_DOUBLE_EQ(learned(3), 0.1); // 1 / (1 + 9)
}

TEST(ResponseModel, differences_that_say_the_same_are_not_divided_by_nothing) {
    ResponseModel model{ResponseOptions()};
    model.beginTimeStep();
    const VectorXd v = VectorXd::Ones(n);
    model.learn(v, v, 0);
    model.learn(v, 2 * v, 0); // contradicts it
    model.learn(VectorXd::Zero(n), v, 0);
    ASSERT_TRUE(model.matrix().A().allFinite() && model.matrix().B().allFinite());
    EXPECT_LE(model.matrix().apply(v, n).norm(), 2 * v.norm() * (1 + 1e-12));
}

TEST(ResponseModel, a_rejected_step_leaves_no_trace) {
    ResponseModel model{ResponseOptions()};
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 0), VectorXd::Ones(n), 0);
    model.acceptTimeStep();
    const MatrixXd B = model.matrix().B();
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 1), VectorXd::Ones(n), 0);
    model.rejectTimeStep();
    EXPECT_EQ(model.matrix().B(), B);
}

/// Response of a mode that the step of another length has not observed, after one that it
/// has: there the fluid responds by `factor` times what it did before.
double unobservedResponse(double ratio, double factor) {
    ResponseModel model(withoutLeastNoise());
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 0), -3 * VectorXd::Unit(n, 0), 0);
    model.learn(VectorXd::Unit(n, 1), -VectorXd::Unit(n, 1), 0);
    model.acceptTimeStep();
    model.changeTimeStep(ratio);
    model.beginTimeStep();
    EXPECT_NEAR(model.matrix().apply(VectorXd::Unit(n, 1), n)[1], -ratio * ratio, 1e-13);
    model.learn(VectorXd::Unit(n, 0), -3 * factor * VectorXd::Unit(n, 0), 0);
    EXPECT_NEAR(model.matrix().apply(VectorXd::Unit(n, 0), n)[0], -3 * factor, 1e-13);
    return -model.matrix().apply(VectorXd::Unit(n, 1), n)[1];
}

TEST(ResponseModel, a_step_of_another_length_shows_how_much_of_the_response_is_inertia) {
    for (const double ratio : {0.5, 2.0, 4.0}) {
        EXPECT_NEAR(unobservedResponse(ratio, ratio * ratio), ratio * ratio, 1e-13);
        EXPECT_NEAR(unobservedResponse(ratio, ratio), ratio, 1e-13); // damping
        EXPECT_NEAR(unobservedResponse(ratio, 1), 1, 1e-13);         // stiffness
    }
    // A force that turns round says nothing about the others.
    EXPECT_NEAR(unobservedResponse(2, -1), 1 / 2.25, 1e-13);
    EXPECT_NEAR(unobservedResponse(2, 100), 4 * 2.25, 1e-13);
}

TEST(ResponseModel, a_step_of_the_same_length_is_not_rescaled) {
    EXPECT_NEAR(unobservedResponse(1, 3), 1, 1e-13);
}

TEST(ResponseModel, a_step_that_is_rejected_twice_is_rescaled_from_the_last_accepted_one) {
    ResponseModel model(withoutLeastNoise());
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 0), VectorXd::Unit(n, 0), 0);
    model.learn(VectorXd::Unit(n, 1), VectorXd::Unit(n, 1), 0);
    model.acceptTimeStep();
    for (int retry = 0; retry < 2; ++retry) {
        model.changeTimeStep(2);
        model.beginTimeStep();
        model.rejectTimeStep();
    }
    model.changeTimeStep(2);
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 0), VectorXd::Unit(n, 0), 0); // stiffness, as before
    EXPECT_NEAR(model.matrix().apply(VectorXd::Unit(n, 1), n)[1], 1, 1e-13);
}

TEST(ResponseModel, a_step_that_was_reset_and_then_rejected_leaves_no_trace) {
    for (const double ratio : {1.0, 2.0}) {
        ResponseModel model(withoutLeastNoise());
        model.beginTimeStep();
        model.learn(VectorXd::Unit(n, 0), VectorXd::Unit(n, 0), 0);
        model.learn(VectorXd::Unit(n, 1), VectorXd::Unit(n, 1), 0);
        model.acceptTimeStep();
        if (ratio != 1) {
            model.changeTimeStep(ratio);
        }
        model.beginTimeStep();
        model.learn(VectorXd::Unit(n, 2), VectorXd::Ones(n), 0);
        model.reset();
        EXPECT_TRUE(model.isEmpty());
        model.learn(VectorXd::Unit(n, 0), VectorXd::Ones(n), 0);
        EXPECT_EQ(model.matrix().rank(), 1);
        model.rejectTimeStep();
        EXPECT_EQ(model.matrix().rank(), 2);
        model.changeTimeStep(2);
        model.beginTimeStep();
        model.learn(VectorXd::Unit(n, 0), VectorXd::Unit(n, 0), 0); // stiffness, as before
        EXPECT_NEAR(model.matrix().apply(VectorXd::Unit(n, 1), n)[1], 1, 1e-13);
    }
}

TEST(ResponseModel, rank_stays_bounded) {
    std::srand(5);
    ResponseOptions options;
    options.maxRank = 8;
    ResponseModel model(options);
    for (int step = 0; step < 20; ++step) {
        model.beginTimeStep();
        model.learn(VectorXd::Random(50), VectorXd::Random(50), 0);
        model.acceptTimeStep();
        EXPECT_LE(model.matrix().rank(), 8);
    }
}

/// A response of -sizes[k] in direction k, known from a step of the length before.
ResponseModel knownBefore(const std::vector<double>& sizes, double ratio) {
    ResponseModel model(withoutLeastNoise());
    model.beginTimeStep();
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const VectorXd v = VectorXd::Unit(n, static_cast<Eigen::Index>(k));
        model.learn(v, -sizes[k] * v, 0);
    }
    model.acceptTimeStep();
    model.changeTimeStep(ratio);
    model.beginTimeStep();
    return model;
}

void learn(ResponseModel& model, int direction, double size, double noise = 0) {
    model.learn(VectorXd::Unit(n, direction), -size * VectorXd::Unit(n, direction), noise);
}

double responseIn(const ResponseModel& model, int direction) {
    return -model.matrix().apply(VectorXd::Unit(n, direction), n)[direction];
}

TEST(ResponseModel, differences_in_a_step_of_another_length_count_whatever_their_size) {
    // One mode of inertia, a thousand times as large as one of stiffness, and one not
    // observed: f that minimises (1 - f)^2 + (1 - 4 f)^2, and 4 f of the response.
    ResponseModel model = knownBefore({1000, 1, 1}, 2);
    learn(model, 0, 4000);
    learn(model, 1, 1);
    EXPECT_NEAR(responseIn(model, 2), 4 * 5.0 / 17, 1e-12);
}

TEST(ResponseModel, differences_in_a_step_of_another_length_count_the_less_the_noisier_they_are) {
    // The stiffness with noise of its own length counts by a half: f minimises
    // (1 - f)^2 + (1 - 4 f)^2 / 2.
    ResponseModel model = knownBefore({1, 1, 1}, 2);
    learn(model, 0, 4);
    learn(model, 1, 1, 1);
    EXPECT_NEAR(responseIn(model, 2), 4 * (1 + 2.0) / (1 + 8.0), 1e-12);
}

TEST(ResponseModel, a_direction_without_a_response_says_nothing_about_the_step) {
    ResponseModel model = knownBefore({1}, 2);
    learn(model, 1, 7); // nothing was known of it
    EXPECT_NEAR(responseIn(model, 0), 4, 1e-13);
}

TEST(ResponseModel, step_of_another_length_is_judged_by_its_own_differences) {
    ResponseModel model = knownBefore({1, 1, 1}, 2);
    learn(model, 0, 1); // stiffness
    model.acceptTimeStep();
    EXPECT_NEAR(responseIn(model, 2), 1, 1e-13);
    model.changeTimeStep(2);
    model.beginTimeStep();
    learn(model, 1, 4); // inertia now
    EXPECT_NEAR(responseIn(model, 2), 4, 1e-13);
}

TEST(ResponseModel, step_after_one_of_another_length_is_not_rescaled) {
    ResponseModel model = knownBefore({1, 1, 1}, 2);
    learn(model, 0, 4);
    model.acceptTimeStep();
    model.beginTimeStep();
    learn(model, 1, 2);
    EXPECT_NEAR(responseIn(model, 2), 4, 1e-13);
}

TEST(ResponseModel, difference_at_the_filters_angle_to_earlier_ones_counts_by_half) {
    ResponseOptions options;
    options.filterLimit = 0.02;
    ResponseModel model(options);
    model.beginTimeStep();
    model.learn(VectorXd::Unit(n, 0), VectorXd::Zero(n), 0);
    VectorXd v = VectorXd::Unit(n, 0);
    v[1] = 0.02; // the tangent
    model.learn(v, VectorXd::Unit(n, 3), 0);
    EXPECT_NEAR(model.matrix().apply(v, n)[3], 0.5, 1e-12);
}

} // namespace
} // namespace tokay::coupling
