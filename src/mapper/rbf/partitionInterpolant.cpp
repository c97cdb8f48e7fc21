// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/DenseLu.hpp"
#include "mapper/rbf/LinearPolynomial.hpp"
#include "mapper/rbf/PrincipalFrame.hpp"
#include "mapper/rbf/RbfInterpolant.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tokay::mapper {

namespace {

struct Ball {
    Point centre;
    double radius;
    std::vector<int> from, to;
};

geometry::Box boxAround(const Points& points, const std::vector<int>& cell) {
    return geometry::Box::around(points(cell, Eigen::all));
}

/// Groups of at most nMost points that lie together: halves of halves.
void appendCells(const Points& points, int nMost, std::vector<int> cell,
                 std::vector<std::vector<int>>& cells) {
    if (static_cast<int>(cell.size()) <= nMost) {
        cells.push_back(std::move(cell));
        return;
    }
    const geometry::Box box = boxAround(points, cell);
    int axis;
    (box.upper - box.lower).maxCoeff(&axis);
    const auto middle = cell.begin() + static_cast<std::ptrdiff_t>(cell.size() / 2);
    std::nth_element(cell.begin(), middle, cell.end(), [&](int a, int b) {
        return std::pair(points(a, axis), a) < std::pair(points(b, axis), b);
    });
    appendCells(points, nMost, {cell.begin(), middle}, cells);
    appendCells(points, nMost, {middle, cell.end()}, cells);
}

std::vector<int> pointsWithin(const Points& points, const geometry::BoxTree& tree,
                              const Point& centre, double radius) {
    std::vector<int> found =
        tree.overlapping({centre - Point::Constant(radius), centre + Point::Constant(radius)});
    found.erase(
        std::remove_if(found.begin(), found.end(),
                       [&](int i) { return (points.row(i).transpose() - centre).norm() > radius; }),
        found.end());
    return found;
}

/// Distance to the n-th nearest point.
double reachOf(const Points& points, const geometry::BoxTree& tree, const Point& centre, int n) {
    double distance = 0;
    tree.visitNearest(centre, [&](int i) {
        distance = (points.row(i).transpose() - centre).norm();
        return --n > 0 ? std::numeric_limits<double>::infinity() : -1.0;
    });
    return distance;
}

/// Ball around a cell that contains nPerBall points, and the cell with some margin.
Ball ballAround(const std::vector<int>& cell, const Points& points, const PrincipalFrame& frame,
                const geometry::BoxTree& tree, int nPerBall) {
    const Point centre = frame.at(boxAround(frame.coordinates(), cell).centre());
    Ball ball{centre, reachOf(points, tree, centre, nPerBall), {}, {}};
    for (const int i : cell) {
        ball.radius = std::max(ball.radius, 1.1 * (points.row(i).transpose() - ball.centre).norm());
    }
    // The farthest point lies inside; of a single one any reach will do.
    ball.radius = ball.radius > 0 ? ball.radius * (1 + 1e-12) : 1;
    ball.from = pointsWithin(points, tree, ball.centre, ball.radius);
    return ball;
}

class Partition : public RbfInterpolant {
  public:
    Partition(const Points& from, const Points& to, const geometry::BoxTree& tree,
              RadialKernel kernel, int nPerBall, double radius)
        : nFrom_(from.rows()) {
        const LinearPolynomial linear(from);
        polynomials_ = linear.values(from);
        polynomialsThere_ = linear.values(to);
        fit_ = DenseLu(polynomials_.transpose() * polynomials_).solve(polynomials_.transpose());
        std::vector<Ball> balls = ballsOver(from, tree, nPerBall);
        assign(from, to, tree, balls);
        const Eigen::VectorXd sums = weightSums(to, balls);
        for (const Ball& ball : balls) {
            if (!ball.to.empty()) {
                blocks_.push_back(
                    blockOf(ball, from, to, {kernel, radius > 0 ? radius : 2 * ball.radius}, sums));
            }
        }
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        const Eigen::MatrixXd fitted = fit_ * values, remainder = values - polynomials_ * fitted;
        Eigen::MatrixXd mapped = polynomialsThere_ * fitted;
        for (const Block& block : blocks_) {
            mapped(block.to, Eigen::all) += block.matrix * remainder(block.from, Eigen::all);
        }
        return mapped;
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(nFrom_, forces.cols());
        for (const Block& block : blocks_) {
            spread(block.from, Eigen::all) +=
                block.matrix.transpose() * forces(block.to, Eigen::all);
        }
        const Eigen::MatrixXd remainder =
            polynomialsThere_.transpose() * forces - polynomials_.transpose() * spread;
        return spread + fit_.transpose() * remainder;
    }
    double bytes() const override {
        double numbers = static_cast<double>(2 * polynomials_.size() + polynomialsThere_.size());
        for (const Block& block : blocks_) {
            numbers += static_cast<double>(block.matrix.size());
        }
        return sizeof(double) * numbers;
    }

  private:
    struct Kernel {
        RadialKernel type;
        double scale;
    };
    /// A ball's interpolation, times its weights.
    struct Block {
        std::vector<int> from, to;
        Eigen::MatrixXd matrix;
    };

    static std::vector<Ball> ballsOver(const Points& from, const geometry::BoxTree& tree,
                                       int nPerBall) {
        std::vector<int> all(from.rows());
        std::iota(all.begin(), all.end(), 0);
        std::vector<std::vector<int>> cells;
        const PrincipalFrame frame(from);
        appendCells(frame.coordinates(), std::max(1, nPerBall / 3), std::move(all), cells);
        std::vector<Ball> balls;
        for (const std::vector<int>& cell : cells) {
            balls.push_back(ballAround(cell, from, frame, tree, nPerBall));
        }
        return balls;
    }

    /// Points of the destination in each ball; one in none goes to a ball that
    /// contains the source point nearest to it.
    static void assign(const Points& from, const Points& to, const geometry::BoxTree& tree,
                       std::vector<Ball>& balls) {
        const geometry::BoxTree treeThere(pointBoxes(to));
        std::vector<char> isInside(to.rows(), 0);
        std::vector<int> ballOf(from.rows(), 0);
        for (std::size_t b = 0; b < balls.size(); ++b) {
            balls[b].to = pointsWithin(to, treeThere, balls[b].centre, balls[b].radius);
            for (const int i : balls[b].to) {
                isInside[i] = 1;
            }
            for (const int i : balls[b].from) {
                ballOf[i] = static_cast<int>(b);
            }
        }
        for (int i = 0; i < to.rows(); ++i) {
            if (!isInside[i]) {
                tree.visitNearest(to.row(i), [&](int nearest) {
                    balls[ballOf[nearest]].to.push_back(i);
                    return -1.0;
                });
            }
        }
    }

    /// Not zero on the rim and beyond, where a point may have no other ball.
    static double weight(const Ball& ball, const Points& to, int i) {
        const double r = (to.row(i).transpose() - ball.centre).norm() / ball.radius;
        return std::max(valueOf(RadialKernel::compactC2, r), 1e-12);
    }

    static Eigen::VectorXd weightSums(const Points& to, const std::vector<Ball>& balls) {
        Eigen::VectorXd sums = Eigen::VectorXd::Zero(to.rows());
        for (const Ball& ball : balls) {
            for (const int i : ball.to) {
                sums[i] += weight(ball, to, i);
            }
        }
        return sums;
    }

    static Block blockOf(const Ball& ball, const Points& from, const Points& to,
                         const Kernel& kernel, const Eigen::VectorXd& sums) {
        const Points here = from(ball.from, Eigen::all), there = to(ball.to, Eigen::all);
        // Across a nearly flat ball the field says nothing about its slope.
        const LinearPolynomial linear(here, 0.05);
        const Eigen::Index n = here.rows(), m = linear.size();
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m),
                        evaluation(there.rows(), n + m);
        system.topLeftCorner(n, n) = kernelMatrix(here, here, kernel.type, kernel.scale);
        system.topRightCorner(n, m) = linear.values(here);
        system.bottomLeftCorner(m, n) = system.topRightCorner(n, m).transpose();
        evaluation << kernelMatrix(there, here, kernel.type, kernel.scale), linear.values(there);
        const Eigen::MatrixXd solved = DenseLu(std::move(system)).solve(evaluation.transpose());
        Block block{ball.from, ball.to, solved.topRows(n).transpose()};
        for (std::size_t i = 0; i < ball.to.size(); ++i) {
            block.matrix.row(static_cast<Eigen::Index>(i)) *=
                weight(ball, to, ball.to[i]) / sums[ball.to[i]];
        }
        return block;
    }

    Eigen::Index nFrom_;
    Eigen::MatrixXd polynomials_, polynomialsThere_;
    /// Coefficients of the linear polynomial by least squares.
    Eigen::MatrixXd fit_;
    std::vector<Block> blocks_;
};

} // namespace

std::unique_ptr<RbfInterpolant> partitionInterpolant(const Points& from, const Points& to,
                                                     const geometry::BoxTree& tree,
                                                     RadialKernel kernel, int nPerBall,
                                                     double radius) {
    return std::make_unique<Partition>(from, to, tree, kernel, nPerBall, radius);
}

} // namespace tokay::mapper
