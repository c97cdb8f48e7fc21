// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/KnotVector.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

/// The functions of a knot vector and their derivatives at the Gauss points of
/// every span that is not empty, evaluated once.
class TabulatedBasis {
  public:
    TabulatedBasis(const geometry::KnotVector& knots, int nPointsPerSpan, int nDerivatives = 1);

    int nSpans() const { return static_cast<int>(firstFunctions_.size()); }
    int nPointsPerSpan() const { return nPoints_; }
    /// Number of functions that are not zero on a span.
    int nFunctions() const { return degree_ + 1; }

    /// Index of the first function that is not zero on a span.
    int firstFunction(int span) const { return firstFunctions_[span]; }

    /// Row k: k-th derivatives; a column a function.
    const Eigen::MatrixXd& at(int span, int point) const { return basis_[span * nPoints_ + point]; }
    double parameter(int span, int point) const { return parameters_[span * nPoints_ + point]; }
    double weight(int span, int point) const { return weights_[span * nPoints_ + point]; }

  private:
    int degree_;
    int nPoints_;
    std::vector<int> firstFunctions_;
    std::vector<Eigen::MatrixXd> basis_;
    std::vector<double> parameters_;
    std::vector<double> weights_;
};

} // namespace tokay::structure
