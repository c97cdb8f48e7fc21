// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/MappingReport.hpp"

#include <Eigen/Core>

namespace tokay::mapper {

/// A transfer of values between two discretisations, and its transpose.
///
/// Most mappings are linear. One that is not (points that turn with the section of
/// a thin body) overrides moved(), variation() and forces(); its apply() is the
/// derivative in the reference configuration.
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

    /// Displacements of the destination, however large.
    /// @param displacements  of the source, nFrom x 3 [m]
    /// @return               nTo x 3 [m]
    virtual Points moved(const Points& displacements) const { return apply(displacements); }

    /// Derivative of moved() at displacements along a variation, both nFrom x 3.
    virtual Points variation(const Points& /*displacements*/, const Points& variation) const {
        return apply(variation);
    }

    /// The transpose of variation(): forces on the source, nFrom x 3 [N].
    /// @param forces  on the destination, nTo x 3 [N]
    virtual Points forces(const Points& /*displacements*/, const Points& forces) const {
        return applyTransposed(forces);
    }

    const MappingReport& report() const { return report_; }

  protected:
    MappingReport report_;
};

} // namespace tokay::mapper
