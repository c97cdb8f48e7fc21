// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/rbf/RadialKernel.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace tokay::mapper {

namespace {
const std::array<const char*, 3> names = {"thinPlate", "compactC2", "compactC6"};
}

RadialKernel radialKernelFromName(const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (name == names[i]) {
            return static_cast<RadialKernel>(i);
        }
    }
    throw InputError(fmt::format("there is no radial basis function \"{}\": choose thinPlate, "
                                 "compactC2 or compactC6",
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
    if (kernel == RadialKernel::compactC2) {
        return std::pow(1 - r, 4) * (4 * r + 1);
    }
    return std::pow(1 - r, 8) * (32 * r * r * r + 25 * r * r + 8 * r + 1);
}

} // namespace tokay::mapper
