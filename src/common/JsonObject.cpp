// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/JsonObject.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay {

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += std::string("\\") + c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += fmt::format("\\u{:04x}", static_cast<int>(c));
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string indented(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '\n' ? std::string("\n  ") : std::string(1, c);
    }
    return result;
}

} // namespace

void JsonObject::add(const std::string& name, double value) {
    addText(name, std::isfinite(value) ? fmt::format("{}", value) : "null");
}

void JsonObject::add(const std::string& name, int value) {
    addText(name, fmt::format("{}", value));
}

void JsonObject::add(const std::string& name, const std::string& value) {
    addText(name, quoted(value));
}

void JsonObject::add(const std::string& name, const JsonObject& value) {
    addText(name, indented(value.text()));
}

void JsonObject::addText(const std::string& name, const std::string& value) {
    members_ += fmt::format("{}\n  {}: {}", members_.empty() ? "" : ",", quoted(name), value);
}

std::string JsonObject::text() const {
    return "{" + members_ + "\n}";
}

} // namespace tokay
