// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <functional>
#include <string>

namespace tokay {

/// Options that know where they were given, so that a mistake found later is
/// reported with "file:line:column: path: ". A reader sets the location; options made
/// in code have none.
struct Located {
    /// Start of a message about an entry; about all of these options if it is empty.
    std::function<std::string(const std::string& entry)> where = [](const std::string& entry) {
        return entry.empty() ? "" : entry + ": ";
    };

    InputError error(const std::string& entry, const std::string& message) const {
        return InputError(where(entry) + message);
    }

    /// Runs a function; errors that it throws get the location of an entry.
    template <class Make>
    auto at(const std::string& entry, const Make& make) const {
        try {
            return make();
        } catch (const InputError& inner) {
            throw error(entry, inner.what());
        }
    }
};

} // namespace tokay
