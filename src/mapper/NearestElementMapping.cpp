#include "mapper/NearestElementMapping.hpp"

#include "common/errors.hpp"
#include "mapper/conservation.hpp"
#include <chrono>
#include <fmt/format.h>

namespace tokay::mapper {

namespace {

void checkPoints(const Points& points) {
    if (points.rows() == 0)
        throw InputError("There is no point to map to: the other side's interface is empty.");
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        if (!points.row(i).allFinite())
            throw InputError(fmt::format("Interface point {} is ({}, {}, {}), not finite.", i,
                                         points(i, 0), points(i, 1), points(i, 2)));
}

void refuseGap(const MappingReport& report, const Points& to, const GapLimit& limit) {
    const auto worst = to.row(report.worstPoint);
    throw InputError(fmt::format(
        "The two sides of the interface do not lie on each other: point {} at ({:.6g}, {:.6g}, "
        "{:.6g}) is {:.4g} m away, {:.3g} of the interface size; the limit is {:.3g} ({} of {} "
        "points are beyond it). Check position and units of both sides, or raise the limit.",
        report.worstPoint, worst[0], worst[1], worst[2], report.largestGap, report.relativeGap,
        limit.relative, report.nUnmatched, report.nPoints));
}

/// Counts a point, whose gap may be the worst so far.
void count(const Location& location, int point, double size, const GapLimit& limit,
           MappingReport& report) {
    if (!location.converged || location.gap > limit.relative * size)
        ++report.nUnmatched;
    if (location.ambiguous)
        ++report.nAmbiguous;
    if (location.gap >= report.largestGap) {
        report.largestGap = location.gap;
        report.worstPoint = point;
    }
}

} // namespace

NearestElementMapping::NearestElementMapping(const Discretisation& from, const Points& to,
                                             const GapLimit& gapLimit)
    : matrix_(to.rows(), from.nValues()) {
    const auto start = std::chrono::steady_clock::now();
    checkPoints(to);
    report_.method = from.mappingName();
    report_.nPoints = static_cast<int>(to.rows());

    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < report_.nPoints; ++i) {
        const Location location = from.locate(to.row(i));
        count(location, i, from.size(), gapLimit, report_);
        for (std::size_t j = 0; j < location.values.size(); ++j)
            entries.emplace_back(i, location.values[j], location.weights[j]);
    }
    report_.relativeGap = report_.largestGap / from.size();
    report_.coverage = 1 - static_cast<double>(report_.nUnmatched) / report_.nPoints;
    if (gapLimit.refuse && report_.relativeGap > gapLimit.relative)
        refuseGap(report_, to, gapLimit);

    matrix_.setFromTriplets(entries.begin(), entries.end());
    measureConservation(matrix_, from.coordinates(), to, report_);
    report_.bytes = bytesOf(matrix_);
    report_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Eigen::MatrixXd NearestElementMapping::apply(const Eigen::MatrixXd& values) const {
    return matrix_ * values;
}

Eigen::MatrixXd NearestElementMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return matrix_.transpose() * forces;
}

} // namespace tokay::mapper
