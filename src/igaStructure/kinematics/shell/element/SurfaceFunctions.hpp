// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"
#include "igaStructure/assembly/rowProducts.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// The functions of an element of a surface at a point with their derivatives up
/// to the second: rows value, 1, 2, 11, 12, 22 (as geometry::derivativeRow).
class SurfaceFunctions {
  public:
    explicit SurfaceFunctions(int nFunctions) : n_(nFunctions), rows_(6, nFunctions) {}

    int size() const { return n_; }
    const double* row(int derivative) const { return rows_.row(derivative); }

    /// Products of functions of one variable.
    /// @param u, v     rows value, first, second derivative; a column a function
    /// @param weights  of the control points; empty: polynomial
    void setProducts(const Eigen::MatrixXd& u, const Eigen::MatrixXd& v,
                     const Eigen::VectorXd& weights);

    /// @param N  at least 6 rows, of which the first are taken
    void set(const Eigen::MatrixXd& N);

    /// Derivatives 1, 2, 11, 12, 22 of a field.
    /// @param coefficients  a column a function
    using Coefficients = Eigen::Matrix<double, 3, Eigen::Dynamic>;
    Eigen::Matrix<double, 3, 5> derivatives(const Coefficients& coefficients) const;
    /// The transpose of derivatives(): adds to the coefficients.
    void addTransposed(const Eigen::Matrix<double, 3, 5>& derivatives,
                       Coefficients& coefficients) const;
    Eigen::Vector3d value(const Coefficients& coefficients) const;

  private:
    void makeRational(const double* sums);

    int n_;
    PaddedRows rows_;
};

} // namespace tokay::structure
