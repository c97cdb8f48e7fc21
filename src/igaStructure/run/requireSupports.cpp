// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/requireSupports.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::structure {

void requireSupports(const Case& structureCase, const StructuralModel& model) {
    const std::vector<std::string> free = model.freeRigidMotions();
    if (!structureCase.timeScheme.dynamic && !free.empty()) {
        throw InputError(fmt::format("{}a static analysis needs supports against every rigid "
                                     "motion, but nothing prevents: {}; add supports, or choose a "
                                     "dynamic time.scheme",
                                     structureCase.supportsPlace, fmt::join(free, ", ")));
    }
}

} // namespace tokay::structure
