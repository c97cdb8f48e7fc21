#include "mapper/RbfMapping.hpp"

#include "common/errors.hpp"
#include "geometry/BoxTree.hpp"
#include "mapper/LinearPolynomial.hpp"
#include "mapper/PointCloud.hpp"
#include "mapper/SparseMatrix.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/conservation.hpp"
#include <Eigen/CholmodSupport>
#include <Eigen/LU>
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace tokay::mapper {

/// Solves K c + P b = values, P^T c = 0; the mapped values are E c + Q b, with
/// kernels E and polynomials Q at the destination.
class RbfMapping::Interpolant {
  public:
    virtual ~Interpolant() = default;
    /// @return E c + Q b
    virtual Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const = 0;
    /// The system is symmetric: its solution for the right-hand sides E^T f, Q^T f.
    virtual Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const = 0;
    virtual double bytes() const = 0;
};

class RbfMapping::Dense : public Interpolant {
  public:
    Dense(const Points& from, const Points& to, RadialKernel kernel, double scale) {
        const LinearPolynomial polynomial(from);
        const Eigen::Index n = from.rows(), m = polynomial.size();
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
        system.topLeftCorner(n, n) = kernels(from, from, kernel, scale);
        system.topRightCorner(n, m) = polynomial.values(from);
        system.bottomLeftCorner(m, n) = system.topRightCorner(n, m).transpose();
        factorised_.compute(system);
        evaluation_.resize(to.rows(), n + m);
        evaluation_ << kernels(to, from, kernel, scale), polynomial.values(to);
        nFrom_ = n;
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(evaluation_.cols(), values.cols());
        rhs.topRows(nFrom_) = values;
        return evaluation_ * factorised_.solve(rhs);
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        const Eigen::MatrixXd rhs = evaluation_.transpose() * forces;
        const Eigen::MatrixXd solution = factorised_.transpose().solve(rhs);
        return solution.topRows(nFrom_);
    }
    double bytes() const override {
        return sizeof(double) *
               static_cast<double>(evaluation_.size() + evaluation_.cols() * evaluation_.cols());
    }

  private:
    static Eigen::MatrixXd kernels(const Points& at, const Points& centres, RadialKernel kernel,
                                   double scale) {
        Eigen::MatrixXd values(at.rows(), centres.rows());
        for (Eigen::Index j = 0; j < centres.rows(); ++j)
            for (Eigen::Index i = 0; i < at.rows(); ++i)
                values(i, j) = valueOf(kernel, (at.row(i) - centres.row(j)).norm() / scale);
        return values;
    }

    Eigen::Index nFrom_;
    Eigen::PartialPivLU<Eigen::MatrixXd> factorised_;
    Eigen::MatrixXd evaluation_;
};

/// K is positive definite: Cholesky, and a Schur complement for the polynomials.
class RbfMapping::Sparse : public Interpolant {
  public:
    Sparse(const Points& from, const Points& to, const geometry::BoxTree& tree, RadialKernel kernel,
           double radius)
        : kernelsThere_(kernels(to, from, tree, kernel, radius)) {
        const Eigen::SparseMatrix<double> matrix = kernels(from, from, tree, kernel, radius);
        factorised_.cholmod().print = 0;
        factorised_.compute(matrix);
        if (factorised_.info() != Eigen::Success)
            throw SolverError(fmt::format("The matrix of the radial basis functions of radius "
                                          "{:.4g} m could not be factorised: choose a smaller "
                                          "radius.",
                                          radius));
        const LinearPolynomial polynomial(from);
        polynomials_ = polynomial.values(from);
        polynomialsThere_ = polynomial.values(to);
        solvedPolynomials_ = factorised_.solve(polynomials_);
        schur_.compute(polynomials_.transpose() * solvedPolynomials_);
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        const Eigen::MatrixXd b = schur_.solve(solvedPolynomials_.transpose() * values);
        const Eigen::MatrixXd rest = values - polynomials_ * b;
        return kernelsThere_ * factorised_.solve(rest) + polynomialsThere_ * b;
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        const Eigen::MatrixXd spread = kernelsThere_.transpose() * forces;
        const Eigen::MatrixXd c = factorised_.solve(spread);
        const Eigen::MatrixXd rest =
            polynomialsThere_.transpose() * forces - polynomials_.transpose() * c;
        return c + solvedPolynomials_ * schur_.solve(rest);
    }
    double bytes() const override { return bytesOf(kernelsThere_); }

  private:
    static SparseMatrix kernels(const Points& at, const Points& centres,
                                const geometry::BoxTree& tree, RadialKernel kernel, double radius) {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < at.rows(); ++i) {
            const Point point = at.row(i);
            for (const int j : tree.overlapping(
                     {point - Point::Constant(radius), point + Point::Constant(radius)})) {
                const double r = (centres.row(j).transpose() - point).norm() / radius;
                if (r < 1)
                    entries.emplace_back(i, j, valueOf(kernel, r));
            }
        }
        SparseMatrix matrix(at.rows(), centres.rows());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    SparseMatrix kernelsThere_;
    Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> factorised_;
    Eigen::MatrixXd polynomials_, polynomialsThere_, solvedPolynomials_;
    Eigen::PartialPivLU<Eigen::MatrixXd> schur_;
};

namespace {

std::vector<geometry::Box> boxesOf(const Points& points) {
    std::vector<geometry::Box> boxes;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        boxes.push_back({points.row(i), points.row(i)});
    return boxes;
}

/// Distance to the k-th nearest other point, ascending order of the tree's visit.
double distanceToNeighbour(const Points& points, const geometry::BoxTree& tree, int point, int k) {
    double distance = 0;
    tree.visitNearest(points.row(point), [&](int other) {
        distance = (points.row(other) - points.row(point)).norm();
        if (other != point)
            --k;
        return k > 0 ? std::numeric_limits<double>::infinity() : -1.0;
    });
    return distance;
}

void refuseCoincidingPoints(const Points& points, const geometry::BoxTree& tree, double size) {
    if (points.rows() < 2)
        return;
    for (int i = 0; i < points.rows(); ++i)
        if (distanceToNeighbour(points, tree, i, 1) <= 1e-12 * size)
            throw InputError(fmt::format("Source point {} at ({:.6g}, {:.6g}, {:.6g}) coincides "
                                         "with another one: radial basis functions need distinct "
                                         "points; merge them.",
                                         i, points(i, 0), points(i, 1), points(i, 2)));
}

/// The largest distance to the k-th neighbour, so that no point is lonely.
double automaticRadius(const Points& points, const geometry::BoxTree& tree, int nNeighbours) {
    const int k = std::min<int>(nNeighbours, static_cast<int>(points.rows()) - 1);
    double radius = 0;
    for (int i = 0; i < points.rows(); ++i)
        radius = std::max(radius, distanceToNeighbour(points, tree, i, k));
    return radius;
}

int defaultNeighbours(const Points& points) {
    constexpr int byAxes[] = {1, 12, 40, 80};
    return byAxes[LinearPolynomial(points).nAxes()];
}

} // namespace

RbfMapping::RbfMapping(const Points& from, const Points& to, const RbfOptions& options) {
    const Stopwatch watch;
    checkPoints(to);
    const PointCloud cloud(from);
    const geometry::BoxTree tree(boxesOf(from));
    refuseCoincidingPoints(from, tree, cloud.size());

    GapStatistics gaps(options.gapLimit, cloud.size());
    for (int i = 0; i < to.rows(); ++i)
        gaps.count(to.row(i), cloud.locate(to.row(i)).gap, true, false);
    report_.method = "radial basis functions, " + nameOf(options.kernel);
    gaps.enter(report_);

    if (options.kernel == RadialKernel::thinPlate) {
        if (from.rows() > maxDensePoints)
            throw InputError(fmt::format("The thin plate kernel needs a dense matrix of {0} x {0} "
                                         "points; the limit is {1}. Choose compactC2 or compactC6.",
                                         from.rows(), maxDensePoints));
        interpolant_ = std::make_unique<Dense>(from, to, options.kernel, cloud.size());
    } else {
        const int nNeighbours =
            options.nNeighbours > 0 ? options.nNeighbours : defaultNeighbours(from);
        radius_ = options.radius > 0 ? options.radius : automaticRadius(from, tree, nNeighbours);
        interpolant_ = std::make_unique<Sparse>(from, to, tree, options.kernel, radius_);
    }
    report_.rowSumError = (apply(Eigen::VectorXd::Ones(from.rows())).array() - 1).abs().maxCoeff();
    measureConservation(*this, testForces(to.rows()), from, to, report_);
    report_.bytes = interpolant_->bytes();
    report_.seconds = watch.seconds();
}

RbfMapping::~RbfMapping() = default;

Eigen::MatrixXd RbfMapping::apply(const Eigen::MatrixXd& values) const {
    return interpolant_->apply(values);
}

Eigen::MatrixXd RbfMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return interpolant_->applyTransposed(forces);
}

} // namespace tokay::mapper
