// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/nearest/NearestElementMapping.hpp"

#include "mapper/Stopwatch.hpp"
#include "mapper/conservation.hpp"

namespace tokay::mapper {

NearestElementMapping::NearestElementMapping(const Discretisation& from, const Points& to,
                                             const GapLimit& gapLimit)
    : matrix_(to.rows(), from.nValues()) {
    const Stopwatch watch;
    checkPoints(to);
    report_.method = from.mappingName();

    GapStatistics gaps(gapLimit, from.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < to.rows(); ++i) {
        const Location location = from.locate(to.row(i));
        gaps.count(to.row(i), location.gap, location.converged, location.ambiguous);
        for (std::size_t j = 0; j < location.values.size(); ++j) {
            entries.emplace_back(i, location.values[j], location.weights[j]);
        }
    }
    gaps.enter(report_);
    matrix_.setFromTriplets(entries.begin(), entries.end());

    report_.rowSumError =
        (apply(Eigen::VectorXd::Ones(from.nValues())).array() - 1).abs().maxCoeff();
    measureConservation(*this, probeForces(to.rows()), from.coordinates(), to, report_);
    report_.bytes = bytesOf(matrix_);
    report_.seconds = watch.seconds();
}

Eigen::MatrixXd NearestElementMapping::apply(const Eigen::MatrixXd& values) const {
    return matrix_ * values;
}

Eigen::MatrixXd NearestElementMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return matrix_.transpose() * forces;
}

} // namespace tokay::mapper
