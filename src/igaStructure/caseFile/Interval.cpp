// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/Interval.hpp"

#include <cassert>
#include <cstdlib>

namespace tokay::structure {

Interval::Interval(const std::string& text)
    : includesLower_(text.front() == '['), includesUpper_(text.back() == ']') {
    const auto comma = text.find(',');
    assert(comma != std::string::npos);
    lower_ = std::strtod(text.c_str() + 1, nullptr);
    upper_ = std::strtod(text.c_str() + comma + 1, nullptr);
}

bool Interval::contains(double x) const {
    const bool aboveLower = includesLower_ ? x >= lower_ : x > lower_;
    const bool belowUpper = includesUpper_ ? x <= upper_ : x < upper_;
    return aboveLower && belowUpper;
}

} // namespace tokay::structure
