// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/timeIntegration/supportRates.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

using Eigen::VectorXd;

SupportRates supportRates(const StructuralModel& model, double time, double interval) {
    if (!model.hasPrescribedMotion()) {
        return {};
    }
    const double h = interval / 3;
    const VectorXd d0 = model.prescribed(time);
    const VectorXd d1 = model.prescribed(time + h);
    const VectorXd d2 = model.prescribed(time + 2 * h);
    const VectorXd d3 = model.prescribed(time + interval);
    return {(-11 * d0 + 18 * d1 - 9 * d2 + 2 * d3) / (6 * h),
            (2 * d0 - 5 * d1 + 4 * d2 - d3) / (h * h)};
}

void requireSupportsAtRest(const StructuralModel& model, double startTime) {
    double largest = model.supportShift(startTime).largest;
    if (model.hasPrescribedMotion()) {
        largest = std::max(largest, model.prescribed(startTime).lpNorm<Eigen::Infinity>());
    }
    // What rounding leaves of formulas that are zero there.
    if (largest > 1e-12 * model.size()) {
        throw InputError(fmt::format(
            "supports: a displacement is {:.3g} m at the start, t = {:g} s, where a body that has "
            "inertia is undeformed: let its formula begin at 0, or use time.scheme static",
            largest, startTime));
    }
}

} // namespace tokay::structure
