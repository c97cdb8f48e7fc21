// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/step/Predictor.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

/// A polynomial in time of the given degree, of two components.
VectorXd polynomial(double time, int degree) {
    VectorXd x(2);
    x << 1 + 2 * std::pow(time, degree), 3 - std::pow(time, degree) + (degree > 0 ? time : 0);
    return x;
}

/// Largest error of the prediction once there are enough steps, all unequal.
double largestError(Extrapolation extrapolation, int degree) {
    Predictor predictor(extrapolation, polynomial(0, degree));
    double time = 0;
    double error = 0;
    for (int step = 0; step < 12; ++step) {
        const double deltaT = 0.1 * (1 + step % 4);
        time += deltaT;
        if (step >= 3) {
            const VectorXd difference = predictor.predict(deltaT) - polynomial(time, degree);
            error = std::max(error, difference.cwiseAbs().maxCoeff());
        }
        predictor.accept(polynomial(time, degree), deltaT);
    }
    return error;
}

TEST(Predictor, is_exact_for_polynomials_of_its_degree_whatever_the_time_steps) {
    const double rounding = 1e-12; // values up to 20, factors up to 10
    EXPECT_LT(largestError(Extrapolation::constant, 0), rounding);
    EXPECT_LT(largestError(Extrapolation::linear, 1), rounding);
    EXPECT_LT(largestError(Extrapolation::quadratic, 2), rounding);
    EXPECT_LT(largestError(Extrapolation::quadratic, 1), rounding);
    EXPECT_LT(largestError(Extrapolation::cubic, 3), rounding);
}

TEST(Predictor, of_each_name_is_exact_for_polynomials_of_that_degree_and_no_higher) {
    const std::vector<std::string> names = {"constant", "linear", "quadratic", "cubic"};
    ASSERT_EQ(extrapolations().size(), names.size());
    for (std::size_t degree = 0; degree < names.size(); ++degree) {
        const auto& choice = extrapolations()[degree];
        EXPECT_EQ(choice.name, names[degree]);
        EXPECT_LT(largestError(choice.value, static_cast<int>(degree)), 1e-11);
        EXPECT_GT(largestError(choice.value, static_cast<int>(degree) + 1), 1e-3);
    }
}

TEST(Predictor, is_not_exact_for_polynomials_of_a_higher_degree) {
    EXPECT_GT(largestError(Extrapolation::constant, 1), 0.1);
    EXPECT_GT(largestError(Extrapolation::linear, 2), 0.01);
}

TEST(Predictor, begins_with_the_degree_that_the_history_allows) {
    Predictor predictor(Extrapolation::quadratic, VectorXd::Constant(1, 5));
    EXPECT_EQ(predictor.predict(0.1)[0], 5);
    predictor.accept(VectorXd::Constant(1, 6), 0.1);
    EXPECT_NEAR(predictor.predict(0.2)[0], 8, 1e-13);
}

TEST(Predictor, of_a_lower_degree_continues_from_what_a_higher_one_has_saved) {
    Predictor cubic(Extrapolation::cubic, VectorXd::Constant(1, 0));
    for (const double x : {1, 8, 27}) { // t^3
        cubic.accept(VectorXd::Constant(1, x), 1);
    }
    std::vector<std::uint8_t> bytes;
    StateWriter written(bytes);
    cubic.save(written);
    StateReader state(bytes);
    Predictor linear(Extrapolation::linear, VectorXd::Zero(1));
    linear.restore(state);
    EXPECT_NEAR(linear.predict(1)[0], 27 + (27 - 8), 1e-12);
}

} // namespace
} // namespace tokay::coupling
