// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/linearAlgebra/SparseLu.hpp"

#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Tridiagonal, not symmetric; the diagonal grows over many decades.
SparseMatrix convection(int n) {
    MatrixXd dense = MatrixXd::Zero(n, n);
    for (int k = 0; k < n; ++k) {
        const double size = std::pow(10.0, 0.3 * k);
        dense(k, k) = 2 * size;
        if (k > 0) {
            dense(k, k - 1) = -1.5 * size;
            dense(k - 1, k) = -0.5;
        }
    }
    return dense.sparseView();
}

} // namespace

TEST(SparseLu, solves_for_the_free_unknowns_and_leaves_fixed_ones_zero) {
    const SparseMatrix matrix = convection(40);
    std::vector<bool> fixed(40, false);
    fixed[3] = fixed[39] = true;
    SparseLu solver(matrix, fixed);
    for (const double factor : {1.0, -3.0}) { // new values of the same sparsity, indefinite
        const SparseMatrix scaled = factor * matrix;
        solver.factorise(scaled);
        VectorXd expected = VectorXd::LinSpaced(40, 1, 3);
        expected[3] = expected[39] = 0;
        // Unknowns are scaled by the diagonal, so its decades cost no digits.
        EXPECT_LT((solver.solve(scaled * expected) - expected).norm(), 1e-12 * expected.norm());
        MatrixXd two(40, 2);
        two << expected, -2 * expected;
        EXPECT_LT((solver.solveAll(scaled * two) - two).norm(), 1e-12 * two.norm());
    }
    EXPECT_EQ(solver.nFree(), 38);
    EXPECT_GE(solver.nFactorEntries(), 38);
}

TEST(SparseLu, singular_matrix_is_refused_though_rounding_hides_it) {
    MatrixXd dense = 2 * MatrixXd::Identity(20, 20);
    dense.diagonal(1).setConstant(-1);
    dense.diagonal(-1).setConstant(-1);
    dense(0, 0) = dense(19, 19) = 1; // constants are its kernel
    const SparseMatrix matrix = dense.sparseView();
    SparseLu solver(matrix, std::vector<bool>(20, false));
    EXPECT_THROW(solver.factorise(matrix), SingularMatrix);
}

TEST(SparseLu, is_chosen_for_general_matrices) {
    const SparseMatrix matrix = convection(5);
    const std::vector<bool> fixed(5, false);
    EXPECT_EQ(makeLinearSolver(matrix, fixed, MatrixKind::general)->name(), "UMFPACK");
    EXPECT_EQ(makeLinearSolver(matrix, fixed, MatrixKind::positiveDefinite)->name(), "CHOLMOD");
    EXPECT_THROW(makeLinearSolver(matrix, std::vector<bool>(5, true), MatrixKind::general),
                 SolverError);
}
