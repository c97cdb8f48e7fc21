// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/rbf/RbfInterpolant.hpp"

#include "common/dense/DenseLu.hpp"
#include "common/errors.hpp"
#include "mapper/RowSparseMatrix.hpp"
#include "mapper/rbf/LinearPolynomial.hpp"

#include <Eigen/CholmodSupport>
#include <fmt/format.h>

#include <utility>

namespace tokay::mapper {

namespace {

class Dense : public RbfInterpolant {
  public:
    Dense(const Points& from, const Points& to, RadialKernel kernel, double scale) {
        const LinearPolynomial polynomial(from);
        const Eigen::Index n = from.rows(), m = polynomial.size();
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
        system.topLeftCorner(n, n) = kernelMatrix(from, from, kernel, scale);
        system.topRightCorner(n, m) = polynomial.values(from);
        system.bottomLeftCorner(m, n) = system.topRightCorner(n, m).transpose();
        factorised_ = DenseLu(std::move(system));
        evaluation_.resize(to.rows(), n + m);
        evaluation_ << kernelMatrix(to, from, kernel, scale), polynomial.values(to);
        nFrom_ = n;
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(evaluation_.cols(), values.cols());
        rhs.topRows(nFrom_) = values;
        return evaluation_ * factorised_.solve(rhs);
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        const Eigen::MatrixXd rhs = evaluation_.transpose() * forces;
        const Eigen::MatrixXd solution = factorised_.solveTransposed(rhs);
        return solution.topRows(nFrom_);
    }
    double bytes() const override {
        return sizeof(double) *
               static_cast<double>(evaluation_.size() + evaluation_.cols() * evaluation_.cols());
    }

  private:
    Eigen::Index nFrom_;
    DenseLu factorised_;
    Eigen::MatrixXd evaluation_;
};

/// K is positive definite: Cholesky, and a Schur complement for the polynomials.
class Sparse : public RbfInterpolant {
  public:
    Sparse(const Points& from, const Points& to, const geometry::BoxTree& tree, RadialKernel kernel,
           double radius)
        : kernelsThere_(kernels(to, from, tree, kernel, radius)) {
        const Eigen::SparseMatrix<double> matrix = kernels(from, from, tree, kernel, radius);
        factorised_.cholmod().print = 0;
        factorised_.compute(matrix);
        if (factorised_.info() != Eigen::Success) {
            throw SolverError(
                fmt::format("the matrix of the radial basis functions of radius {:.4g} m "
                            "could not be factorised: choose a smaller radius",
                            radius));
        }
        const LinearPolynomial polynomial(from);
        polynomials_ = polynomial.values(from);
        polynomialsThere_ = polynomial.values(to);
        solvedPolynomials_ = factorised_.solve(polynomials_);
        schur_ = DenseLu(polynomials_.transpose() * solvedPolynomials_);
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        const Eigen::MatrixXd b = schur_.solve(solvedPolynomials_.transpose() * values);
        const Eigen::MatrixXd remainder = values - polynomials_ * b;
        return kernelsThere_ * factorised_.solve(remainder) + polynomialsThere_ * b;
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        const Eigen::MatrixXd spread = kernelsThere_.transpose() * forces;
        const Eigen::MatrixXd c = factorised_.solve(spread);
        const Eigen::MatrixXd remainder =
            polynomialsThere_.transpose() * forces - polynomials_.transpose() * c;
        return c + solvedPolynomials_ * schur_.solve(remainder);
    }
    double bytes() const override { return bytesOf(kernelsThere_); }

  private:
    static RowSparseMatrix kernels(const Points& at, const Points& centres,
                                   const geometry::BoxTree& tree, RadialKernel kernel,
                                   double radius) {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < at.rows(); ++i) {
            const Point point = at.row(i);
            for (const int j : tree.overlapping(
                     {point - Point::Constant(radius), point + Point::Constant(radius)})) {
                const double r = (centres.row(j).transpose() - point).norm() / radius;
                if (r < 1) {
                    entries.emplace_back(i, j, valueOf(kernel, r));
                }
            }
        }
        RowSparseMatrix matrix(at.rows(), centres.rows());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    RowSparseMatrix kernelsThere_;
    Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> factorised_;
    Eigen::MatrixXd polynomials_, polynomialsThere_, solvedPolynomials_;
    DenseLu schur_;
};

} // namespace

std::unique_ptr<RbfInterpolant> denseInterpolant(const Points& from, const Points& to,
                                                 RadialKernel kernel, double scale) {
    return std::make_unique<Dense>(from, to, kernel, scale);
}

std::unique_ptr<RbfInterpolant> sparseInterpolant(const Points& from, const Points& to,
                                                  const geometry::BoxTree& tree,
                                                  RadialKernel kernel, double radius) {
    return std::make_unique<Sparse>(from, to, tree, kernel, radius);
}

std::vector<geometry::Box> pointBoxes(const Points& points) {
    std::vector<geometry::Box> boxes;
    boxes.reserve(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        boxes.push_back({points.row(i), points.row(i)});
    }
    return boxes;
}

Eigen::MatrixXd kernelMatrix(const Points& at, const Points& centres, RadialKernel kernel,
                             double scale) {
    Eigen::MatrixXd values(at.rows(), centres.rows());
    for (Eigen::Index j = 0; j < centres.rows(); ++j) {
        for (Eigen::Index i = 0; i < at.rows(); ++i) {
            values(i, j) = valueOf(kernel, (at.row(i) - centres.row(j)).norm() / scale);
        }
    }
    return values;
}

} // namespace tokay::mapper
