// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include "common/errors.hpp"
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// (K - shift M)^-1 as Spectra calls it, without the part along modes that are known:
/// these have the eigenvalue 0. Fixed unknowns are zero in its results.
class ShiftedInverse {
  public:
    using Scalar = double;

    ShiftedInverse(const SparseMatrix& stiffness, const SparseMatrix& mass,
                   const std::vector<bool>& fixed)
        : stiffness_(stiffness), mass_(mass), solver_(stiffness, fixed) {}

    Eigen::Index rows() const { return stiffness_.rows(); }
    Eigen::Index cols() const { return stiffness_.cols(); }

    void set_shift(double shift) {
        if (shift != shift_) {
            const SparseMatrix shifted = stiffness_ - shift * mass_;
            solver_.factorise(shifted);
            shift_ = shift;
        }
    }

    void perform_op(const double* in, double* out) {
        const Eigen::Index n = rows();
        Eigen::Map<VectorXd>(out, n) = solve(Eigen::Map<const VectorXd>(in, n));
    }

    VectorXd solve(const VectorXd& force) {
        const VectorXd solution = solver_.solve(force);
        return known_.cols() == 0
                   ? solution
                   : VectorXd(solution - known_ * (massTimesKnown_.transpose() * solution));
    }

    /// @param modes  orthogonal, of modal mass 1, a column each
    void leaveOut(const MatrixXd& modes) {
        known_ = modes;
        massTimesKnown_ = mass_ * modes;
    }
    int nKnown() const { return static_cast<int>(known_.cols()); }

  private:
    const SparseMatrix& stiffness_;
    const SparseMatrix& mass_;
    SparseCholesky solver_;
    double shift_ = std::numeric_limits<double>::quiet_NaN();
    MatrixXd known_, massTimesKnown_;
};

/// Squares of frequencies, the lowest first, and shapes.
struct Modes {
    VectorXd squares;
    MatrixXd shapes;
};

// Of unknowns that depend on others, the part in the energy of these (Galerkin).
SparseMatrix ofFree(const StructuralModel& model, SparseMatrix matrix) {
    const SparseMatrix* extension = model.extension();
    return extension ? SparseMatrix(extension->transpose() * matrix * *extension) : matrix;
}

/// The lowest modes of a structure, by Lanczos' method on the shifted inverse.
class ModeFinder {
  public:
    explicit ModeFinder(const StructuralModel& model)
        : mass_(ofFree(model, model.massMatrix())),
          stiffness_(ofFree(model, stiffnessAtRest(model))),
          inverse_(stiffness_, mass_, model.fixed()), massProduct_(mass_),
          nFree_(static_cast<int>(std::count(model.fixed().begin(), model.fixed().end(), false))) {
        // With rigid motions free, K - shift M is positive definite for a negative shift
        // only: one of the order of the lowest squares of frequencies.
        highest_ = VectorXd(stiffness_.diagonal()).sum() / VectorXd(mass_.diagonal()).sum();
        shift_ = model.freeRigidMotions().empty()
                     ? 0
                     : -highest_ / std::pow(static_cast<double>(model.nUnknowns()), 2);
    }

    // From one vector Lanczos' method finds one mode of each frequency; where several share
    // it, as a ring's do, the others come by rounding, or not. Those that were missed are
    // the lowest of what is left without the ones found.
    Modes find(int count) {
        Modes found = lowest(count);
        MatrixXd known = found.shapes;
        while (known.cols() + 1 < nFree_) {
            inverse_.leaveOut(known);
            const Modes missed = lowest(1);
            const double last = found.squares[count - 1];
            if (missed.squares[0] >= last - 1e-9 * std::abs(last) - 1e-13 * highest_) {
                break;
            }
            known.conservativeResize(Eigen::NoChange, known.cols() + 1);
            known.rightCols(1) = missed.shapes;
            found = lowestOf(found, missed, count);
        }
        return found;
    }

    int nFree() const { return nFree_; }

  private:
    Modes lowest(int count) {
        const int nLeft = nFree_ - inverse_.nKnown();
        const int nVectors = std::min(nLeft, std::max(2 * count + 1, count + 20));
        Spectra::SymGEigsShiftSolver<ShiftedInverse, Spectra::SparseSymMatProd<double>,
                                     Spectra::GEigsMode::ShiftInvert>
            solver(inverse_, massProduct_, count, nVectors, shift_);
        // A start that lies in the space of the modes: fixed unknowns are zero. Another one in
        // each search: of modes that share a frequency a start has one combination, and once
        // that is known, none of the others.
        const double wave = 1.7 + 0.618 * inverse_.nKnown();
        VectorXd start(mass_.rows());
        for (Eigen::Index k = 0; k < start.size(); ++k) {
            start[k] = std::sin(1.0 + wave * static_cast<double>(k)); // has a part of every mode
        }
        start = inverse_.solve(mass_ * start);
        solver.init(start.data());
        solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12,
                       Spectra::SortRule::SmallestAlge);
        if (solver.info() != Spectra::CompInfo::Successful) {
            throw SolverError(fmt::format("the iteration for {} natural modes of {} unknowns did "
                                          "not converge; ask for fewer modes",
                                          count, nFree_));
        }
        return {solver.eigenvalues(), solver.eigenvectors()};
    }

    static Modes lowestOf(const Modes& found, const Modes& missed, int count) {
        const auto behind =
            std::upper_bound(found.squares.begin(), found.squares.end(), missed.squares[0]);
        const auto place = behind - found.squares.begin();
        const auto nAfter = count - 1 - place;
        Modes all = found;
        all.squares[place] = missed.squares[0];
        all.squares.tail(nAfter) = found.squares.segment(place, nAfter);
        all.shapes.col(place) = missed.shapes.col(0);
        all.shapes.rightCols(nAfter) = found.shapes.middleCols(place, nAfter);
        return all;
    }

    SparseMatrix mass_;
    SparseMatrix stiffness_;
    ShiftedInverse inverse_;
    Spectra::SparseSymMatProd<double> massProduct_;
    int nFree_;
    double highest_; ///< order of the highest square of a frequency
    double shift_;
};

} // namespace

NaturalModes naturalModes(const StructuralModel& model, int count) {
    ModeFinder finder(model);
    if (count >= finder.nFree()) {
        throw InputError(fmt::format("{} modes are wanted of a structure with {} free unknowns; "
                                     "use more elements",
                                     count, finder.nFree()));
    }
    const Modes modes = finder.find(count);
    return {modes.squares.cwiseMax(0).cwiseSqrt(),
            model.extension() ? *model.extension() * modes.shapes : modes.shapes};
}

} // namespace tokay::structure
