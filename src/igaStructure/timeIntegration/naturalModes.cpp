// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include "common/errors.hpp"
#include "igaStructure/linearAlgebra/SparseCholesky.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

/// (K - shift M)^-1 as Spectra calls it; fixed unknowns are zero in its results.
class ShiftedInverse {
  public:
    using Scalar = double;

    ShiftedInverse(const SparseMatrix& stiffness, const SparseMatrix& mass,
                   const std::vector<bool>& fixed)
        : stiffness_(stiffness), mass_(mass), solver_(stiffness, fixed) {}

    Eigen::Index rows() const { return stiffness_.rows(); }
    Eigen::Index cols() const { return stiffness_.cols(); }

    void set_shift(double shift) {
        const SparseMatrix shifted = stiffness_ - shift * mass_;
        solver_.factorise(shifted);
    }

    void perform_op(const double* in, double* out) {
        const Eigen::Index n = rows();
        Eigen::Map<VectorXd>(out, n) = solver_.solve(Eigen::Map<const VectorXd>(in, n));
    }

    VectorXd solve(const VectorXd& force) { return solver_.solve(force); }

  private:
    const SparseMatrix& stiffness_;
    const SparseMatrix& mass_;
    SparseCholesky solver_;
};

// With rigid motions free, K - shift M is positive definite for a negative shift
// only: one of the order of the lowest squares of frequencies.
double shiftFor(const StructuralModel& model, const SparseMatrix& stiffness,
                const SparseMatrix& mass) {
    if (model.freeRigidMotions().empty()) {
        return 0;
    }
    const double highest = VectorXd(stiffness.diagonal()).sum() / VectorXd(mass.diagonal()).sum();
    return -highest / std::pow(static_cast<double>(model.nUnknowns()), 2);
}

} // namespace

NaturalModes naturalModes(const StructuralModel& model, int count) {
    const auto& fixed = model.fixed();
    const auto nFree = static_cast<int>(std::count(fixed.begin(), fixed.end(), false));
    if (count >= nFree) {
        throw InputError(fmt::format("{} modes are wanted of a structure with {} free unknowns; "
                                     "use more elements",
                                     count, nFree));
    }
    SparseMatrix stiffness;
    model.internalForce(VectorXd::Zero(model.nUnknowns()), stiffness);
    const SparseMatrix mass = model.massMatrix();
    ShiftedInverse inverse(stiffness, mass, fixed);
    Spectra::SparseSymMatProd<double> massProduct(mass);
    const int nVectors = std::min(nFree, std::max(2 * count + 1, count + 20));
    Spectra::SymGEigsShiftSolver<ShiftedInverse, Spectra::SparseSymMatProd<double>,
                                 Spectra::GEigsMode::ShiftInvert>
        solver(inverse, massProduct, count, nVectors, shiftFor(model, stiffness, mass));
    // A start that lies in the space of the modes: fixed unknowns are zero.
    VectorXd start(model.nUnknowns());
    for (Eigen::Index k = 0; k < start.size(); ++k) {
        start[k] = std::sin(1.0 + 1.7 * static_cast<double>(k)); // has a part of every mode
    }
    start = inverse.solve(mass * start);
    solver.init(start.data());
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
    if (solver.info() != Spectra::CompInfo::Successful) {
        throw SolverError(fmt::format("the iteration for {} natural modes of {} unknowns did not "
                                      "converge; ask for fewer modes",
                                      count, nFree));
    }
    NaturalModes modes;
    modes.angularFrequencies = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
    modes.shapes = solver.eigenvectors();
    return modes;
}

} // namespace tokay::structure
