// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Range.hpp"

#include <cassert>
#include <cstdlib>

namespace tokay {

Range::Range(const char* text) : text_(text) {
    if (text_.empty()) {
        return;
    }
    const auto comma = text_.find(',');
    assert(comma != std::string::npos);
    lower_ = std::strtod(text_.c_str() + 1, nullptr);
    upper_ = std::strtod(text_.c_str() + comma + 1, nullptr);
}

bool Range::contains(double x) const {
    if (text_.empty()) {
        return true;
    }
    const bool isAboveLower = text_.front() == '[' ? x >= lower_ : x > lower_;
    const bool isBelowUpper = text_.back() == ']' ? x <= upper_ : x < upper_;
    return isAboveLower && isBelowUpper;
}

} // namespace tokay
