#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/MappingReport.hpp"
#include "mapper/SparseMatrix.hpp"

namespace tokay::mapper {

struct GapLimit {
    /// Largest gap allowed, relative to the size of the interface.
    double relative = 0.01;
    /// False: points beyond the limit are counted as unmatched and take the
    /// values of their projection all the same.
    bool refuse = true;
};

/// Values at points by the functions of the closest element: exact spline
/// evaluation for a spline interface.
class NearestElementMapping {
  public:
    /// @param to  destination points, nTo x 3 [m]
    /// @throws InputError that names the worst point, its gap and the limit, if
    /// a point is too far away or not finite.
    NearestElementMapping(const Discretisation& from, const Points& to,
                          const GapLimit& gapLimit = {});

    /// nTo x nValues.
    const SparseMatrix& matrix() const { return matrix_; }

    /// Consistent: constants (and what the elements can represent) are exact.
    /// @param values  nValues x m
    /// @return        nTo x m
    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const;

    /// Conservative: sums and virtual work are kept.
    /// @param forces  nTo x m
    /// @return        nValues x m
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const;

    const MappingReport& report() const { return report_; }

  private:
    SparseMatrix matrix_;
    MappingReport report_;
};

} // namespace tokay::mapper
