// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/rowProducts.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace tokay::structure {

/// Stiffness of an element of a shell or solid, summed over its quadrature points:
/// D^T H D with the functions' derivatives D and the Hessian H of the energy at each
/// point. A few points together are one dense product.
class ElementTangent {
  public:
    /// @param nVectors  2: the energy depends on the base vectors only; 5: on second
    ///                  derivatives too; 3: on the gradient in space
    explicit ElementTangent(int nVectors) : nVectors_(nVectors) {}

    int nVectors() const { return nVectors_; }

    /// Zero, for an element of so many functions.
    void start(int nFunctions);

    /// @param derivatives  the first of nVectors rows, a number a function
    /// @param stride       from row to row
    /// @param hessian      times quadrature weight and area; component d of derivative r is
    ///                     number 3 r + d
    void add(const double* derivatives, std::ptrdiff_t stride,
             const Eigen::Ref<const Eigen::MatrixXd>& hessian);

    /// Component c of function k is number 3 k + c.
    const Eigen::MatrixXd& finish();

  private:
    void multiply();

    static constexpr int most_ = 8; ///< points a product: so it stays in the cache
    int nVectors_;
    int nFunctions_ = 0;
    int nPoints_ = 0;
    std::vector<double> hessians_;
    std::vector<const double*> locations_; ///< of the points' Hessians
    std::optional<PaddedRows> functions_, right_, sum_;
    Eigen::MatrixXd matrix_;
};

} // namespace tokay::structure
