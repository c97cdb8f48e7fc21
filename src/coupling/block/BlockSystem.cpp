// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/BlockSystem.hpp"

#include "common/errors.hpp"

namespace tokay::coupling {
namespace {

constexpr int maxIterations = 40;

/// What is left of the imbalance is rounding error (a linear structure gets
/// there in one step, and need not be factored again to notice).
constexpr double rounding = 1e-11;

/// Factor by which the error may fall less than the imbalance in a Newton iteration, which
/// hardly shows soft modes beside stiff ones.
constexpr double softness = 10;

} // namespace

/// L(x(d)) - R(d)
Eigen::VectorXd BlockSystem::imbalance(const Eigen::VectorXd& d) const {
    const Eigen::VectorXd move = structure_.displacements(d) - xOfLoads_;
    return loads_ + J_.apply(move, loads_.size()) - structure_.residual(d);
}

Eigen::VectorXd BlockSystem::solve(Eigen::VectorXd d, double tolerance) const {
    Eigen::VectorXd current = imbalance(d);
    const double start = current.norm();
    bool reuses = structure_.reuseContraction() > 0;
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        if (current.norm() <= rounding * start) {
            return d;
        }
        if (!reuses) {
            structure_.linearise(d);
        }
        const Eigen::VectorXd step = steps_.solve(J_, current);
        double length = 1;
        Eigen::VectorXd next = d + step;
        Eigen::VectorXd nextImbalance = imbalance(next);
        const auto hasDecreased = [&] {
            return nextImbalance.norm() <= (1 - 1e-4 * length) * current.norm();
        };
        const auto isShort = [&] { return length * step.norm() <= tolerance * next.norm(); };
        const auto isClose = [&] {
            const double left = softness * nextImbalance.norm() / current.norm();
            return left * length * step.norm() <= tolerance * next.norm();
        };
        const bool serves = nextImbalance.norm() <= structure_.reuseContraction() * current.norm();
        if (reuses && !serves) {
            reuses = false; // the same step with a new tangent
            continue;
        }
        reuses = serves;
        while (!hasDecreased() && length > 1e-3 && !isShort()) {
            length /= 2;
            next = d + length * step;
            nextImbalance = imbalance(next);
        }
        if ((isShort() || isClose()) && nextImbalance.allFinite()) {
            return next;
        }
        if (!hasDecreased()) {
            break; // in no length of this direction
        }
        d = next;
        current = nextImbalance;
    }
    throw SolverError("the structural solution in the fluid was not found by Newton's method: use "
                      "smaller time steps");
}

} // namespace tokay::coupling
