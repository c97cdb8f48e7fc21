// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay {

/// Text of a JSON object, member by member.
class JsonObject {
  public:
    /// Every digit of the number; null if it is not finite.
    void add(const std::string& name, double value);
    void add(const std::string& name, int value);
    void add(const std::string& name, const std::string& value);
    void add(const std::string& name, const JsonObject& value);

    /// A member a line, indented by two spaces a level.
    std::string text() const;

  private:
    void addText(const std::string& name, const std::string& value);

    std::string members_;
};

} // namespace tokay
