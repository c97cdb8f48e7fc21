// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/chosenFields.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

std::vector<std::string> chosenFields(const Body& body, const OutputOptions& options) {
    const std::vector<std::string> known = body.fieldNames();
    for (const std::string& field : options.fields) {
        if (std::find(known.begin(), known.end(), field) == known.end()) {
            throw InputError(fmt::format("output.fields: this structure has no '{}'; it has: {}",
                                         field, fmt::join(known, ", ")));
        }
    }
    return options.fields.empty() ? body.defaultFields() : options.fields;
}

} // namespace tokay::structure
