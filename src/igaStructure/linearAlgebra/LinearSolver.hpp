// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// The matrix is not positive definite.
class NotPositiveDefinite : public SolverError {
  public:
    NotPositiveDefinite(int theUnknown, const std::string& message)
        : SolverError(message), unknown(theUnknown) {}
    int unknown; ///< where the first pivot that is not positive was met
};

/// The matrix is singular, or nearly.
class SingularMatrix : public SolverError {
  public:
    using SolverError::SolverError;
};

/// Factorisation of a matrix without the rows and columns of fixed unknowns.
/// Analysed once for its sparsity, factored for new values as often as needed,
/// kept for many solutions. Unknowns are scaled by the diagonal, so their units
/// and sizes do not matter.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    /// @param matrix  with the sparsity given at construction
    /// @throws NotPositiveDefinite or SingularMatrix; SolverError if memory does
    ///         not suffice
    virtual void factorise(const SparseMatrix& matrix) = 0;

    /// Solution for a right-hand side; fixed unknowns are zero in it.
    /// Needs a factorisation.
    Eigen::VectorXd solve(const Eigen::VectorXd& rightHandSide) { return solveAll(rightHandSide); }
    /// Solutions for several right-hand sides, a column each.
    virtual Eigen::MatrixXd solveAll(const Eigen::MatrixXd& rightHandSides) = 0;

    virtual int nFree() const = 0;
    /// Entries of the factors; before a factorisation those that are expected.
    virtual double nFactorEntries() const = 0;
    /// Memory of the factors and of their matrix [bytes].
    virtual double bytes() const = 0;
    /// Name of the solver library, for the log.
    virtual std::string name() const = 0;
};

enum class MatrixKind { positiveDefinite, general };

/// Cholesky's factorisation, or for general matrices LU, which takes twice the
/// operations and memory.
/// @param pattern    both triangles, sorted columns; values are not used
/// @param fixed      unknowns left out
/// @param extension  E, if unknowns depend on others (StructuralModel::extension()): the
///                   solver then takes the free rows of the matrix times E, by LU, and gives
///                   E times their solution; is kept by reference
/// @throws SolverError if every unknown is fixed
std::unique_ptr<LinearSolver> makeLinearSolver(const SparseMatrix& pattern,
                                               const std::vector<bool>& fixed, MatrixKind kind,
                                               const SparseMatrix* extension = nullptr);

} // namespace tokay::structure
