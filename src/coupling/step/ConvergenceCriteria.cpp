// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/step/ConvergenceCriteria.hpp"

#include "common/errors.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace tokay::coupling {
namespace {

double rootMeanSquare(const Eigen::VectorXd& values) {
    return values.size() == 0 ? 0 : values.norm() / std::sqrt(double(values.size()));
}

double ratio(double norm, double allowed) {
    return norm == 0 ? 0 : norm / allowed;
}

} // namespace

ConvergenceCriteria::ConvergenceCriteria(const ConvergenceOptions& options, double tolerance)
    : tolerance_(tolerance), options_(options) {
    if (!(tolerance > 0 && tolerance <= 1)) {
        throw InputError("the coupling tolerance is " + std::to_string(tolerance) +
                         ": it must be above 0, and below 1 unless the coupling is "
                         "explicit; it is the fluid's residualControl for the "
                         "structure");
    }
}

double ConvergenceCriteria::residual(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                                     const Eigen::VectorXd& forces) {
    return std::max(displacementResidual(x, xTilde), tolerance_ * forceRatio(forces));
}

double ConvergenceCriteria::displacementResidual(const Eigen::VectorXd& x,
                                                 const Eigen::VectorXd& xTilde) const {
    assert(xTilde.size() == x.size());
    if (!xTilde.allFinite()) {
        throw SolverError("the structure's displacement is not finite");
    }
    const double scale = std::max(rootMeanSquare(x), rootMeanSquare(xTilde));
    return tolerance_ * ratio(rootMeanSquare(xTilde - x),
                              std::max(tolerance_ * scale, options_.absoluteDisplacement));
}

double ConvergenceCriteria::forceRatio(const Eigen::VectorXd& forces) {
    if (!options_.limitsForce()) {
        return 0;
    }
    double result = 1 / tolerance_;
    if (previousForces_.size() == forces.size()) {
        result = ratio(
            rootMeanSquare(forces - previousForces_),
            std::max(options_.relativeForce * rootMeanSquare(forces), options_.absoluteForce));
    }
    previousForces_ = forces;
    return result;
}

} // namespace tokay::coupling
