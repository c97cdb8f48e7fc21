// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"

#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The 1D Laplacian's stencil (-1, 2, -1).
SparseMatrix laplacian(int n) {
    MatrixXd dense = 2 * MatrixXd::Identity(n, n);
    dense.diagonal(1).setConstant(-1);
    dense.diagonal(-1).setConstant(-1);
    return dense.sparseView();
}

} // namespace

TEST(SparseCholesky, solves_for_the_free_unknowns_and_leaves_fixed_ones_zero) {
    const SparseMatrix matrix = laplacian(50);
    std::vector<bool> fixed(50, false);
    fixed[0] = fixed[20] = true;
    SparseCholesky solver(matrix, fixed);
    solver.factorise(matrix);
    const VectorXd b = VectorXd::LinSpaced(50, 1, 3);
    const VectorXd x = solver.solve(b);
    EXPECT_EQ(solver.nFree(), 48);
    EXPECT_EQ(x[0], 0);
    EXPECT_EQ(x[20], 0);
    VectorXd residual = b - matrix * x;
    residual[0] = residual[20] = 0;
    EXPECT_LT(residual.norm(), 1e-12 * b.norm()); // condition about 1e3
}

TEST(SparseCholesky, factors_new_values_of_the_same_sparsity) {
    SparseMatrix matrix = laplacian(20);
    SparseCholesky solver(matrix, std::vector<bool>(20, false));
    const VectorXd b = VectorXd::Ones(20);
    solver.factorise(matrix);
    const VectorXd x = solver.solve(b);
    matrix *= 2;
    solver.factorise(matrix);
    EXPECT_LT((solver.solve(b) - 0.5 * x).norm(), 1e-13 * x.norm());
}

TEST(SparseCholesky, solves_for_several_right_hand_sides_at_once_as_for_each) {
    const SparseMatrix matrix = laplacian(30);
    std::vector<bool> fixed(30, false);
    fixed[3] = true;
    SparseCholesky solver(matrix, fixed);
    solver.factorise(matrix);
    for (const int nColumns : {7, 2, 9}) {
        const MatrixXd B = MatrixXd::Random(30, nColumns);
        const MatrixXd X = solver.solveAll(B);
        for (int k = 0; k < nColumns; ++k) {
            // Rounding of sums in another order, condition about 1e3
            EXPECT_LT((X.col(k) - solver.solve(B.col(k))).norm(), 1e-12 * X.col(k).norm());
        }
    }
}

TEST(SparseCholesky, indefinite_matrix_is_refused) {
    SparseMatrix matrix = laplacian(20);
    matrix.coeffRef(7, 7) = -1;
    SparseCholesky solver(matrix, std::vector<bool>(20, false));
    EXPECT_THROW(solver.factorise(matrix), NotPositiveDefinite);
}

TEST(SparseCholesky, singular_matrix_is_refused_though_rounding_hides_it) {
    SparseMatrix matrix = laplacian(20); // free at both ends: constants are its kernel
    matrix.coeffRef(0, 0) = matrix.coeffRef(19, 19) = 1;
    SparseCholesky solver(matrix, std::vector<bool>(20, false));
    EXPECT_THROW(solver.factorise(matrix), NotPositiveDefinite);
}

TEST(SparseCholesky, matrix_without_free_unknowns_is_refused) {
    EXPECT_THROW(SparseCholesky(laplacian(3), std::vector<bool>(3, true)), SolverError);
}
