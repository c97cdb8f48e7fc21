// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/MappingReport.hpp"

#include <Eigen/Core>

namespace tokay::mapper {

/// A linear transfer of values between two discretisations, and its transpose.
class Mapping {
  public:
    virtual ~Mapping() = default;

    /// Consistent: constants (and what both sides can represent) are exact.
    /// @param values  nFrom x m
    /// @return        nTo x m
    virtual Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const = 0;

    /// Conservative: sums and virtual work are kept.
    /// @param forces  nTo x m
    /// @return        nFrom x m
    virtual Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const = 0;

    const MappingReport& report() const { return report_; }

  protected:
    MappingReport report_;
};

} // namespace tokay::mapper
