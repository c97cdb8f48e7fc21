// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/rbf/RadialKernel.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace tokay::mapper {

namespace {
const std::array<const char*, 4> names = {"thinPlate", "compactC2", "compactC4", "compactC6"};
}

RadialKernel radialKernelFromName(const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (name == names[i]) {
            return static_cast<RadialKernel>(i);
        }
    }
    throw InputError(fmt::format("there is no radial basis function \"{}\": choose thinPlate, "
                                 "compactC2, compactC4 or compactC6",
                                 name));
}

std::string nameOf(RadialKernel kernel) {
    return names[static_cast<int>(kernel)];
}

double valueOf(RadialKernel kernel, double r) {
    if (kernel == RadialKernel::thinPlate) {
        return r > 0 ? r * r * std::log(r) : 0;
    }
    if (r >= 1) {
        return 0;
    }
    // Products, because pow takes several times as long
    const double squared = (1 - r) * (1 - r);
    const double fourth = squared * squared;
    switch (kernel) {
    case RadialKernel::compactC2:
        return fourth * (4 * r + 1);
    case RadialKernel::compactC4:
        return fourth * squared * ((35 * r + 18) * r + 3) / 3;
    default:
        return fourth * fourth * (((32 * r + 25) * r + 8) * r + 1);
    }
}

} // namespace tokay::mapper
