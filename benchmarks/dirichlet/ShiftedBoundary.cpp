// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShiftedBoundary.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"

#include <Eigen/Eigenvalues>

#include <chrono>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using geometry::ElementState;

namespace {

/// The square's patch and its equations. Parameters are coordinates.
class ShiftedProblem {
  public:
    ShiftedProblem(const PoissonSquare& square, int degree, int n, int order);

    const SparseMatrix& stiffness() const { return stiffness_; }
    const VectorXd& lumpedMass() const { return lumpedMass_; }
    const VectorXd& load() const { return load_; }
    const std::vector<bool>& fixed() const { return fixed_; }
    std::vector<int> free() const;
    const geometry::KnotVector& knots() const { return patch_.basis().u(); }
    PoissonError error(const VectorXd& w) const;

  private:
    geometry::SurfaceBasis basis(int element, const Vector2d& x, int nDerivatives) const;
    template <class Visit>
    void forEachPoint(int element, Visit visit) const;
    void addElement(int element);
    void addFaces(int element);
    void addFacePoint(int element, const Vector2d& x, const Vector2d& normal, double weight);
    void add(const std::vector<int>& functions, const MatrixXd& matrix, const VectorXd& load);
    void findFixed();

    PoissonSquare square_;
    geometry::TrimmedPatch patch_;
    int n_, degree_, order_;
    std::vector<Eigen::Triplet<double>> entries_;
    SparseMatrix stiffness_;
    VectorXd lumpedMass_, load_;
    std::vector<bool> fixed_; ///< on the square's edges, or without a whole element
};

ShiftedProblem::ShiftedProblem(const PoissonSquare& square, int degree, int n, int order)
    : square_(square), patch_(square.patch(degree, n)), n_(n), degree_(degree), order_(order) {
    const int nFunctions = patch_.basis().nControlPoints();
    lumpedMass_ = load_ = VectorXd::Zero(nFunctions);
    for (const int element : patch_.elements(ElementState::full)) {
        addElement(element);
        addFaces(element);
    }
    stiffness_.resize(nFunctions, nFunctions);
    stiffness_.setFromTriplets(entries_.begin(), entries_.end());
    findFixed();
}

geometry::SurfaceBasis ShiftedProblem::basis(int element, const Vector2d& x,
                                             int nDerivatives) const {
    return geometry::spanBasis(patch_.basis(), degree_ + element % n_, degree_ + element / n_, x[0],
                               x[1], nDerivatives);
}

template <class Visit>
void ShiftedProblem::forEachPoint(int element, Visit visit) const {
    const geometry::ParameterBox box = patch_.elementBox(element);
    const auto& rule = geometry::gaussLegendre(degree_ + 1);
    for (std::size_t j = 0; j < rule.points.size(); ++j) {
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const Vector2d local(rule.points[i], rule.points[j]);
            visit(Vector2d(box.lower + local.cwiseProduct(box.size())),
                  rule.weights[i] * rule.weights[j] * box.area());
        }
    }
}

void ShiftedProblem::add(const std::vector<int>& functions, const MatrixXd& matrix,
                         const VectorXd& load) {
    load_(functions) += load;
    for (std::size_t j = 0; j < functions.size(); ++j) {
        for (std::size_t i = 0; i < functions.size(); ++i) {
            entries_.emplace_back(
                functions[i], functions[j],
                matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
        }
    }
}

void ShiftedProblem::addElement(int element) {
    forEachPoint(element, [&](const Vector2d& x, double weight) {
        const geometry::SurfaceBasis at = basis(element, x, 1);
        const MatrixXd gradient = at.N.middleRows<2>(1);
        add(at.controlPoints, weight * gradient.transpose() * gradient,
            weight * PoissonSquare::load(x[0], x[1]) * at.N.row(0).transpose());
        lumpedMass_(at.controlPoints) += weight * at.N.row(0).transpose();
    });
}

// Those next to elements that are cut or empty; the square's own edges are none.
void ShiftedProblem::addFaces(int element) {
    const geometry::ParameterBox box = patch_.elementBox(element);
    const auto& rule = geometry::gaussLegendre(degree_ + 1 + order_);
    for (int axis = 0; axis < 2; ++axis) {
        for (const int side : {-1, 1}) {
            const int index = axis == 0 ? element % n_ : element / n_;
            const int neighbour = element + side * (axis == 0 ? 1 : n_);
            if (index + side < 0 || index + side >= n_ ||
                patch_.state(neighbour) == ElementState::full) {
                continue;
            }
            for (std::size_t g = 0; g < rule.points.size(); ++g) {
                Vector2d x = box.lower + rule.points[g] * box.size();
                x[axis] = side < 0 ? box.lower[axis] : box.lower[axis] + box.size()[axis];
                addFacePoint(element, x, side * Vector2d::Unit(axis), rule.weights[g] / n_);
            }
        }
    }
}

void ShiftedProblem::addFacePoint(int element, const Vector2d& x, const Vector2d& normal,
                                  double weight) {
    const Vector2d fromCentre = x - square_.centre;
    const Vector2d nearest = square_.centre + square_.radius * fromCentre.normalized();
    const Vector2d d = nearest - x;
    const geometry::SurfaceBasis at = basis(element, x, std::max(order_, 1));
    RowVectorXd shifted = RowVectorXd::Zero(at.N.cols());
    for (int k = 0; k <= order_; ++k) {
        for (int l = 0; k + l <= order_; ++l) {
            const double factor =
                std::pow(d[0], k) * std::pow(d[1], l) / (std::tgamma(k + 1) * std::tgamma(l + 1));
            shifted += factor * at.N.row(geometry::derivativeRow(k, l));
        }
    }
    const RowVectorXd slope = normal.transpose() * at.N.middleRows<2>(1);
    // As large as a trace inequality for polynomials of the degree wants it.
    const double stiffness = 10 * degree_ * degree_ * n_;
    const double given = PoissonSquare::solution(nearest[0], nearest[1]);
    const RowVectorXd test = stiffness * shifted - slope;
    add(at.controlPoints, weight * (test.transpose() * shifted - at.N.row(0).transpose() * slope),
        weight * given * test.transpose());
}

void ShiftedProblem::findFixed() {
    const int nRow = patch_.basis().u().nBasis();
    for (int k = 0; k < stiffness_.rows(); ++k) {
        const int i = k % nRow, j = k / nRow;
        const bool isRim = i == 0 || j == 0 || i == nRow - 1 || j == nRow - 1;
        fixed_.push_back(isRim || !(lumpedMass_[k] > 0));
    }
}

std::vector<int> ShiftedProblem::free() const {
    std::vector<int> free;
    for (int k = 0; k < stiffness_.rows(); ++k) {
        if (!fixed_[k]) {
            free.push_back(k);
        }
    }
    return free;
}

PoissonError ShiftedProblem::error(const VectorXd& w) const {
    Eigen::Array2d squares = Eigen::Array2d::Zero();
    for (const int element : patch_.elements(ElementState::full)) {
        forEachPoint(element, [&](const Vector2d& x, double weight) {
            const geometry::SurfaceBasis at = basis(element, x, 1);
            const Eigen::Vector3d values = at.N * w(at.controlPoints);
            const Vector2d slope = values.tail<2>() - PoissonSquare::gradient(x[0], x[1]);
            squares += weight *
                       Eigen::Array2d(std::pow(values[0] - PoissonSquare::solution(x[0], x[1]), 2),
                                      slope.squaredNorm());
        });
    }
    return {std::sqrt(squares[0]), std::sqrt(squares[1])};
}

} // namespace

PoissonResult ShiftedBoundary::solve(const PoissonSquare& square, int degree, int n) const {
    const auto start = std::chrono::steady_clock::now();
    const ShiftedProblem problem(square, degree, n, order_ > 0 ? order_ : degree);
    VectorXd w = rimValues(problem.knots()).reshaped();
    const auto solver = makeLinearSolver(problem.stiffness(), problem.fixed(), MatrixKind::general);
    solver->factorise(problem.stiffness());
    w += solver->solve(problem.load() - problem.stiffness() * w);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return {problem.error(w), 1, seconds.count()};
}

MatrixXd ShiftedBoundary::matrix(const PoissonSquare& square, int degree, int n) const {
    const ShiftedProblem problem(square, degree, n, order_ > 0 ? order_ : degree);
    const std::vector<int> free = problem.free();
    return MatrixXd(problem.stiffness())(free, free);
}

double ShiftedBoundary::stableStep(const PoissonSquare& square, int degree, int n) const {
    const ShiftedProblem problem(square, degree, n, order_ > 0 ? order_ : degree);
    const std::vector<int> free = problem.free();
    const VectorXd mass = problem.lumpedMass()(free);
    const MatrixXd accelerations =
        mass.cwiseInverse().asDiagonal() * MatrixXd(problem.stiffness())(free, free);
    return 2 / std::sqrt(accelerations.eigenvalues().cwiseAbs().maxCoeff());
}

} // namespace tokay::structure
