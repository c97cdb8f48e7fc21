// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace tokay::channel {

/// Appends values to a buffer, little-endian whatever the machine; strings
/// and arrays are preceded by their number of elements (uint32).
class ByteWriter {
  public:
    explicit ByteWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

    void operator()(std::uint8_t value) { bytes_.push_back(value); }
    void operator()(bool value) { bytes_.push_back(value ? 1 : 0); }
    void operator()(Role value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
    void operator()(State value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
    void operator()(std::uint32_t value) { littleEndian(value); }
    void operator()(double value) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        littleEndian(bits);
    }
    void operator()(const std::optional<InterfaceBalance>& balance) {
        (*this)(balance.has_value());
        if (balance) {
            std::apply([&](const auto&... value) { ((*this)(value), ...); }, numbersOf(*balance));
        }
    }
    void operator()(const std::optional<double>& value) {
        (*this)(value.has_value());
        if (value) {
            (*this)(*value);
        }
    }
    template <std::size_t size>
    void operator()(const std::array<std::uint8_t, size>& bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    void operator()(const std::string& text) {
        count(text.size());
        bytes_.insert(bytes_.end(), text.begin(), text.end());
    }
    template <class Value>
    void operator()(const std::vector<Value>& values) {
        count(values.size());
        bytes_.reserve(bytes_.size() + values.size() * sizeof(Value));
        for (const Value value : values) {
            (*this)(value);
        }
    }

  private:
    void count(std::size_t n) { littleEndian(static_cast<std::uint32_t>(n)); }

    template <class Unsigned>
    void littleEndian(Unsigned value) {
        for (std::size_t i = 0; i < sizeof value; ++i) {
            bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        }
    }

    std::vector<std::uint8_t>& bytes_;
};

} // namespace tokay::channel
