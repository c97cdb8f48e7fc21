// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "poissonSquare.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// What a solution of Poisson's problem took, and its errors.
struct PoissonResult {
    PoissonError error;
    int nSolutions;
    double seconds;
};

/// A way to hold the rim of the disc in Poisson's problem.
class Method {
  public:
    explicit Method(std::string name) : name_(std::move(name)) {}
    virtual ~Method() = default;

    const std::string& name() const { return name_; }
    virtual int maxDegree() const { return 4; }

    virtual PoissonResult solve(const PoissonSquare& square, int degree, int n) const = 0;
    /// The matrix that is solved, of free deflections.
    virtual Eigen::MatrixXd matrix(const PoissonSquare& square, int degree, int n) const = 0;
    /// Largest stable step of central differences with the lumped mass [s].
    virtual double stableStep(const PoissonSquare& square, int degree, int n) const = 0;

  private:
    std::string name_;
};

/// Condition number in the 2-norm.
double conditionOf(const Eigen::MatrixXd& matrix);

} // namespace tokay::structure
