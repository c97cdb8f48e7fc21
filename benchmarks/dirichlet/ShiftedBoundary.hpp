// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Method.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"

namespace tokay::structure {

/// The shifted boundary method. Elements that the disc cuts are left out; on what then
/// bounds the mesh, apart from the disc by d, Nitsche's method holds not the solution but
/// its Taylor polynomial at the nearest point of the rim,
///   S w = sum_{k <= order} (d . grad)^k w / k!.
/// In every bilinear form w is the solution and v the test function:
///   (grad w, grad v) - <dw/dn, v> - <S w, dv/dn> + (alpha / h) <S w, S v>
///     = (f, v) - <g, dv/dn> + (alpha / h) <g, S v>.
/// Errors are those on the elements that are left.
/// Source: Main & Scovazzi 2018 (order 1); Atallah, Canuto & Scovazzi 2022 (higher orders)
class ShiftedBoundary : public Method {
  public:
    /// @param order  of the Taylor polynomial; 0: the degree
    ShiftedBoundary(std::string name, int order) : Method(std::move(name)), order_(order) {}

    PoissonResult solve(const PoissonSquare& square, int degree, int n) const override;
    Eigen::MatrixXd matrix(const PoissonSquare& square, int degree, int n) const override;
    double stableStep(const PoissonSquare& square, int degree, int n) const override;

  private:
    int order_;
};

} // namespace tokay::structure
