// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace tokay::channel {

/// Index of the first value that is NaN or infinite, if there is one.
inline std::optional<std::size_t> firstNonFinite(const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            return i;
        }
    }
    return std::nullopt;
}

inline bool allFinite(const std::vector<double>& values) {
    return !firstNonFinite(values);
}

} // namespace tokay::channel
