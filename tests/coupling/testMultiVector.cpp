// SPDX-License-Identifier: GPL-3.0-or-later
#include "LinearResponse.hpp"
#include "coupling/fixedPoint/MultiVectorModel.hpp"
#include "coupling/fixedPoint/Mvqn.hpp"

#include <gtest/gtest.h>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding = 1e-12; // of some hundred operations on values of size one

/// Without guards and filter: the method of the textbook.
MultiVectorOptions bare() {
    MultiVectorOptions options;
    options.signalToNoise = 0;
    options.maxStep = 0;
    options.keepFraction = 0;
    options.filterLimit = 0;
    return options;
}

/// Teaches the model what A does to nPairs random vectors.
void teach(MultiVectorModel& model, const MatrixXd& A, int nPairs) {
    for (int i = 0; i < nPairs; ++i) {
        const VectorXd v = VectorXd::Random(A.cols());
        model.learn(v, A * v);
    }
}

MatrixXd dense(const MultiVectorModel& model, const MatrixXd& like) {
    MatrixXd result(like.rows(), like.cols());
    for (Eigen::Index i = 0; i < like.cols(); ++i) {
        result.col(i) = model.apply(VectorXd::Unit(like.cols(), i), like.rows());
    }
    return result;
}

TEST(MultiVectorModel, satisfies_every_secant_of_the_step_and_else_keeps_the_old_jacobian) {
    std::srand(11);
    const MatrixXd old = MatrixXd::Random(6, 5); // forces and displacements: not square
    const MatrixXd current = MatrixXd::Random(6, 5);
    MultiVectorModel model(bare());
    teach(model, old, 5);
    model.acceptTimeStep();
    const VectorXd v1 = VectorXd::Random(5);
    const VectorXd v2 = VectorXd::Random(5);
    model.learn(v1, current * v1);
    model.learn(v2, current * v2);
    EXPECT_LT((model.apply(v1, 6) - current * v1).norm(), rounding);
    EXPECT_LT((model.apply(v2, 6) - current * v2).norm(), rounding);
    MatrixXd V(5, 2);
    V << v1, v2;
    const MatrixXd complement = V.fullPivHouseholderQr().matrixQ().rightCols(3);
    EXPECT_LT(((dense(model, old) - old) * complement).norm(), rounding);
}

TEST(MultiVectorModel, product_equals_what_is_applied) {
    std::srand(12);
    const MatrixXd A = MatrixXd::Random(6, 5);
    MultiVectorModel model(bare());
    teach(model, A, 2);
    model.acceptTimeStep();
    teach(model, A, 2);
    const LowRankMatrix product = model.matrix();
    EXPECT_LT((product.A() * product.B().transpose() - dense(model, A)).norm(), rounding);
}

TEST(MultiVectorModel, learns_a_linear_map_from_steps_that_each_show_a_part) {
    std::srand(13);
    const MatrixXd A = MatrixXd::Random(6, 6);
    MultiVectorModel model(bare());
    for (int step = 0; step < 40; ++step) {
        teach(model, A, 2);
        model.acceptTimeStep();
    }
    // Two random directions of six take a third of the squared error, on average.
    EXPECT_LT((dense(model, A) - A).norm(), std::pow(2.0 / 3.0, 40.0 / 2) * A.norm());
}

TEST(MultiVectorModel, rank_stays_bounded_and_restart_loses_nothing_of_a_map_of_smaller_rank) {
    std::srand(14);
    const MatrixXd A = MatrixXd::Random(50, 4) * MatrixXd::Random(4, 40);
    MultiVectorOptions options = bare();
    options.maxRank = 12;
    MultiVectorModel model(options);
    teach(model, A, 10);
    for (int step = 0; step < 30; ++step) {
        teach(model, A, 3);
        model.acceptTimeStep();
        EXPECT_LE(model.rank(), 12);
    }
    const VectorXd v = VectorXd::Random(40);
    model.learn(v, A * v);
    EXPECT_LT((model.apply(v, 50) - A * v).norm(), 1e-10 * (A * v).norm());
}

TEST(MultiVectorModel, small_differences_are_not_carried_on) {
    const auto learned = [](double keepFraction) {
        MultiVectorOptions options = bare();
        options.keepFraction = keepFraction;
        MultiVectorModel model(options);
        model.learn(VectorXd::Unit(3, 0), VectorXd::Unit(3, 0));
        model.learn(VectorXd::Unit(3, 1), 0.04 * VectorXd::Unit(3, 1));
        // Within the step they count.
        EXPECT_NEAR(model.apply(VectorXd::Unit(3, 1), 3)[1], 0.04, rounding);
        model.acceptTimeStep();
        EXPECT_NEAR(model.apply(VectorXd::Unit(3, 0), 3)[0], 1, rounding);
        return model.apply(VectorXd::Unit(3, 1), 3)[1];
    };
    EXPECT_NEAR(learned(0.03), 0.04, rounding);
    EXPECT_NEAR(learned(0.05), 0, rounding);
}

TEST(MultiVectorModel, a_rejected_step_is_forgotten) {
    std::srand(15);
    const MatrixXd A = MatrixXd::Random(5, 5);
    MultiVectorModel model(bare());
    teach(model, A, 3);
    model.acceptTimeStep();
    const MatrixXd before = dense(model, A);
    teach(model, -7 * A, 4);
    model.rejectTimeStep();
    EXPECT_EQ(dense(model, A), before);
}

TEST(Mvqn, solves_a_linear_problem_of_n_unknowns_in_n_plus_one_iterations) {
    for (const int n : {1, 2, 5, 12}) {
        std::srand(static_cast<unsigned>(n));
        const LinearResponse response{MatrixXd::Random(n, n), VectorXd::Random(n)};
        Mvqn method(bare());
        // Rounding errors grow with the condition of n differences (here 1e4).
        EXPECT_LT(response.error(iterated(method, response, n + 1)), 1e-9) << n << " unknowns";
    }
}

TEST(Mvqn, one_iteration_is_enough_in_a_later_step_of_a_linear_problem) {
    VectorXd ratios(5);
    ratios << 1000, 50, 10, 1, 0.1;
    LinearResponse response = addedMass(ratios);
    Mvqn method(bare());
    iterated(method, response, 6);
    method.acceptTimeStep();
    response.b.reverseInPlace(); // another step: other loads, the same response
    EXPECT_LT(response.error(iterated(method, response, 1)), 1e-9);
}

} // namespace
} // namespace tokay::coupling
