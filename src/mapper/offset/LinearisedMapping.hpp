// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/offset/OffsetMapping.hpp"

namespace tokay::mapper {

/// An offset mapping's derivative in the reference configuration, at every displacement:
/// what a body with linear strains moves by. It is a matrix, so that a use costs one product.
class LinearisedMapping : public Mapping {
  public:
    /// To the points of the mapping.
    explicit LinearisedMapping(const OffsetMapping& mapping);

    /// To weighted sums of its points, as the faces are on which a force is spread over
    /// quadrature points: however many they are, the product is with the faces.
    /// @param shares  weight of each point in each sum, nPoints x nSums
    LinearisedMapping(const OffsetMapping& mapping, const RowSparseMatrix& shares);

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override;
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override;

  private:
    RowSparseMatrix derivative_; ///< 3 nTo x 3 nFrom
};

} // namespace tokay::mapper
