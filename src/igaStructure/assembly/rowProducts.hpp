// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tokay::structure {

/// Stacked rows of doubles, each padded so that products may read and write
/// beyond its end.
class PaddedRows {
  public:
    /// Zero.
    PaddedRows(int nRows, int nColumns);

    double* row(int i) { return values_.data() + static_cast<std::ptrdiff_t>(i) * stride_; }
    const double* row(int i) const {
        return values_.data() + static_cast<std::ptrdiff_t>(i) * stride_;
    }
    int stride() const { return stride_; }
    void setZero();

  private:
    int stride_;
    std::vector<double> values_;
};

/// Products of an element's tangent, in the widest vector instructions that the
/// processor has. Row r of `functions` holds the values of one derivative of all
/// functions of the element at one point, in groups of nVectors rows a point.

/// For one component d of the force, right = H D: row 5 g + r, column c n + k, is the
/// sum over s of H_g(3 r + d, 3 s + c) times derivative s of function k at point g,
/// for the components c from d on.
/// @param hessians  3 nVectors square (column-major) of each point
/// @param nVectors  2, 3 or 5
void multiplyHessians(const std::vector<const double*>& hessians, const PaddedRows& functions,
                      int nVectors, int nFunctions, int component, PaddedRows& right);

/// target(d n + k, c n + l) += sum over rows of functions(row, k) right(row, c n + l), at
/// least for c n + l >= d n + k.
void addProduct(const PaddedRows& functions, const PaddedRows& right, int nRows, int nFunctions,
                int component, PaddedRows& target);

} // namespace tokay::structure
