// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/checkSizes.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::tool {

namespace {

/// The power of ten that the ratio is, to a third; else the ratio.
double likelyScale(double ratio) {
    const double power = std::pow(10, std::round(std::log10(ratio)));
    return std::abs(std::log(ratio / power)) < std::log(1.33) ? power : ratio;
}

} // namespace

void checkSizes(const Side& from, const Side& to) {
    constexpr double mostRatio = 100;
    const double sizeFrom = from.discretisation().size(), sizeTo = to.discretisation().size();
    if (sizeFrom <= mostRatio * sizeTo && sizeTo <= mostRatio * sizeFrom) {
        return;
    }
    throw InputError(fmt::format("the two sides differ in size by a factor of {:.4g}:\n  "
                                 "{}\n  {}\nis one in mm and the other in m? give the first a "
                                 "scale (--scale-from {:.4g}), or confirm the sizes "
                                 "(--scale-from 1)",
                                 std::max(sizeFrom / sizeTo, sizeTo / sizeFrom), from.description(),
                                 to.description(), likelyScale(sizeTo / sizeFrom)));
}

} // namespace tokay::tool
