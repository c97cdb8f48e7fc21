// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay {

/// Range of a number, written as in mathematics: "(0, 1]" is 0 < x <= 1; "inf" and
/// "-inf" are allowed ends. An empty text allows every number.
class Range {
  public:
    Range(const char* text = ""); // implicit: a row of a schema reads as a table's

    bool contains(double x) const;
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    double lower_ = 0;
    double upper_ = 0;
};

} // namespace tokay
