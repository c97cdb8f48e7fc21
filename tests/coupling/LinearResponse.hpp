// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/Accelerator.hpp"

#include <Eigen/Dense>

namespace tokay::coupling {

/// A fluid and a structure that respond linearly: xTilde = A x + b.
struct LinearResponse {
    Eigen::MatrixXd A;
    Eigen::VectorXd b;

    Eigen::VectorXd operator()(const Eigen::VectorXd& x) const { return A * x + b; }

    Eigen::VectorXd solution() const {
        const Eigen::Index n = b.size();
        return (Eigen::MatrixXd::Identity(n, n) - A).partialPivLu().solve(b);
    }

    double error(const Eigen::VectorXd& x) const {
        return (x - solution()).norm() / solution().norm();
    }
};

/// Independent modes, each opposed by `ratios[i]` times its own inertia: what
/// a light structure in a heavy fluid does. |A| > 1 defeats plain iteration.
inline LinearResponse addedMass(const Eigen::VectorXd& ratios) {
    const Eigen::Index n = ratios.size();
    std::srand(3);
    const Eigen::MatrixXd modes =
        Eigen::HouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd::Random(n, n)).householderQ();
    return {-modes * ratios.asDiagonal() * modes.transpose(), Eigen::VectorXd::Random(n)};
}

/// x after n calls of next, from zero, with a fluid without errors.
inline Eigen::VectorXd iterated(Accelerator& accelerator, const LinearResponse& response, int n) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(response.b.size());
    accelerator.beginTimeStep();
    for (int i = 0; i < n; ++i) {
        x = accelerator.next(x, response(x), 0);
    }
    return x;
}

} // namespace tokay::coupling
