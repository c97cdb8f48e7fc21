// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::structure {

/// Range of a number, written as in mathematics: "(0, 1]" is 0 < x <= 1; "inf"
/// and "-inf" are allowed ends.
class Interval {
  public:
    explicit Interval(const std::string& text);
    bool contains(double x) const;

  private:
    double lower_, upper_;
    bool includesLower_, includesUpper_;
};

} // namespace tokay::structure
