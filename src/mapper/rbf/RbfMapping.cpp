// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/rbf/RbfMapping.hpp"

#include "common/errors.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/conservation.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/rbf/LinearPolynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tokay::mapper {

namespace {

/// Distance to the k-th nearest other point, ascending order of the tree's visit.
double distanceToNeighbour(const Points& points, const geometry::BoxTree& tree, int point, int k) {
    double distance = 0;
    tree.visitNearest(points.row(point), [&](int other) {
        distance = (points.row(other) - points.row(point)).norm();
        if (other != point) {
            --k;
        }
        return k > 0 ? std::numeric_limits<double>::infinity() : -1.0;
    });
    return distance;
}

void refuseCoincidingPoints(const Points& points, const geometry::BoxTree& tree, double size) {
    if (points.rows() < 2) {
        return;
    }
    for (int i = 0; i < points.rows(); ++i) {
        if (distanceToNeighbour(points, tree, i, 1) <= 1e-12 * size) {
            throw InputError(
                fmt::format("source point {} at ({:.6g}, {:.6g}, {:.6g}) coincides with "
                            "another one: radial basis functions need distinct points; "
                            "merge them",
                            i, points(i, 0), points(i, 1), points(i, 2)));
        }
    }
}

/// The largest distance to the k-th neighbour, so that no point is lonely.
double automaticRadius(const Points& points, const geometry::BoxTree& tree, int nNeighbours) {
    const int k = std::min<int>(nNeighbours, static_cast<int>(points.rows()) - 1);
    double radius = 0;
    for (int i = 0; i < points.rows(); ++i) {
        radius = std::max(radius, distanceToNeighbour(points, tree, i, k));
    }
    return radius;
}

/// Memory of the thin plate's values at the destination.
double denseBytes(Eigen::Index nFrom, Eigen::Index nTo) {
    return sizeof(double) * static_cast<double>(nFrom) * static_cast<double>(nTo);
}

void refuseTooManyDensePoints(Eigen::Index nFrom, Eigen::Index nTo) {
    if (nFrom > RbfMapping::maxDensePoints) {
        throw InputError(fmt::format("the thin plate kernel needs a dense matrix of {0} x {0} "
                                     "points; the limit is {1}; choose the partition of unity, or "
                                     "compactC2, compactC4 or compactC6",
                                     nFrom, RbfMapping::maxDensePoints));
    }
    if (denseBytes(nFrom, nTo) > RbfMapping::maxDenseBytes) {
        throw InputError(fmt::format("the thin plate kernel solved globally needs a dense matrix "
                                     "of {} destination x {} source points, {:.3g} GB; the limit "
                                     "is {:.3g} GB; choose the partition of unity, or compactC2, "
                                     "compactC4 or compactC6",
                                     nTo, nFrom, denseBytes(nFrom, nTo) / 1e9,
                                     RbfMapping::maxDenseBytes / 1e9));
    }
}

int defaultNeighbours(const Points& points) {
    constexpr int byAxes[] = {1, 12, 40, 80};
    return byAxes[LinearPolynomial(points).nAxes()];
}

} // namespace

RbfSolution chosenSolution(const RbfOptions& options, Eigen::Index nFrom, Eigen::Index nTo) {
    constexpr Eigen::Index mostPoints = 300;
    if (options.solution != RbfSolution::automatic) {
        return options.solution;
    }
    const bool isGlobal =
        options.kernel == RadialKernel::thinPlate
            ? nFrom <= mostPoints && denseBytes(nFrom, nTo) <= RbfMapping::maxDenseBytes
            : options.nNeighbours > 0;
    return isGlobal ? RbfSolution::global : RbfSolution::partitionOfUnity;
}

RbfMapping::RbfMapping(const Points& from, const Points& to, const RbfOptions& options) {
    const Stopwatch watch;
    checkPoints(to);
    const PointCloud cloud(from);
    const geometry::BoxTree tree(pointBoxes(from));
    refuseCoincidingPoints(from, tree, cloud.size());

    GapStatistics gaps(options.gapLimit, cloud.size());
    for (int i = 0; i < to.rows(); ++i) {
        gaps.count(to.row(i), cloud.locate(to.row(i)).gap, true, false);
    }
    report_.method = "radial basis functions, " + nameOf(options.kernel);
    gaps.enter(report_);

    if (chosenSolution(options, from.rows(), to.rows()) == RbfSolution::partitionOfUnity) {
        radius_ = options.kernel == RadialKernel::thinPlate ? 0 : options.radius;
        interpolant_ =
            partitionInterpolant(from, to, tree, options.kernel, options.nPerBall, radius_);
        report_.method += ", partition of unity";
    } else if (options.kernel == RadialKernel::thinPlate) {
        refuseTooManyDensePoints(from.rows(), to.rows());
        interpolant_ = denseInterpolant(from, to, options.kernel, cloud.size());
    } else {
        const int nNeighbours =
            options.nNeighbours > 0 ? options.nNeighbours : defaultNeighbours(from);
        radius_ = options.radius > 0 ? options.radius : automaticRadius(from, tree, nNeighbours);
        interpolant_ = sparseInterpolant(from, to, tree, options.kernel, radius_);
    }
    report_.rowSumError = (apply(Eigen::VectorXd::Ones(from.rows())).array() - 1).abs().maxCoeff();
    measureConservation(*this, probeForces(to.rows()), from, to, report_);
    report_.bytes = interpolant_->bytes();
    report_.seconds = watch.seconds();
}

Eigen::MatrixXd RbfMapping::apply(const Eigen::MatrixXd& values) const {
    return interpolant_->apply(values);
}

Eigen::MatrixXd RbfMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return interpolant_->applyTransposed(forces);
}

} // namespace tokay::mapper
