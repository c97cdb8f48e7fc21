// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/requireSupports.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::structure {

void requireSupports(const Case& structureCase, const StructuralModel& model) {
    const std::vector<std::string> loose = model.looseParts();
    if (!loose.empty()) {
        throw InputError(fmt::format("{}nothing supports or joins: {}; let their edges coincide "
                                     "with those of other patches, or support them",
                                     structureCase.supportsPlace, fmt::join(loose, "; ")));
    }
    const std::vector<std::string> free = model.freeRigidMotions();
    if (!structureCase.isDynamic() && !free.empty()) {
        throw InputError(fmt::format("{}a static analysis needs supports against every rigid "
                                     "motion, but nothing prevents: {}; add supports, or choose a "
                                     "dynamic time.scheme",
                                     structureCase.supportsPlace, fmt::join(free, ", ")));
    }
}

} // namespace tokay::structure
