// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/PeerError.hpp"
#include "channel/messages.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <tuple>
#include <vector>

namespace tokay::channel {

/// Reads what ByteWriter wrote. Each call throws PeerError if the bytes that
/// remain cannot hold the value, before anything is allocated.
class ByteReader {
  public:
    ByteReader(const std::uint8_t* begin, std::size_t size) : next_(begin), remaining_(size) {}

    std::size_t remaining() const { return remaining_; }

    void operator()(bool& value) { value = enumerator(1, "a truth value") != 0; }
    void operator()(Role& value) { value = static_cast<Role>(enumerator(2, "a role")); }
    void operator()(State& value) { value = static_cast<State>(enumerator(3, "a state")); }
    void operator()(std::uint32_t& value) { value = littleEndian<std::uint32_t>(); }
    void operator()(double& value) {
        const auto bits = littleEndian<std::uint64_t>();
        std::memcpy(&value, &bits, sizeof value);
    }
    void operator()(std::optional<InterfaceBalance>& balance) {
        bool given = false;
        (*this)(given);
        balance.reset();
        if (given) {
            std::apply([&](auto&... value) { ((*this)(value), ...); },
                       numbersOf(balance.emplace()));
        }
    }
    void operator()(std::optional<double>& value) {
        bool given = false;
        (*this)(given);
        value.reset();
        if (given) {
            (*this)(value.emplace());
        }
    }
    template <std::size_t size>
    void operator()(std::array<std::uint8_t, size>& bytes) {
        for (std::uint8_t& byte : bytes) {
            byte = littleEndian<std::uint8_t>();
        }
    }
    void operator()(std::string& text) {
        const std::size_t n = count(1);
        text.assign(reinterpret_cast<const char*>(next_), n);
        advance(n);
    }
    template <class Value>
    void operator()(std::vector<Value>& values) {
        values.resize(count(sizeof(Value)));
        for (Value& value : values) {
            (*this)(value);
        }
    }

  private:
    std::size_t count(std::size_t bytesEach) {
        const std::size_t n = littleEndian<std::uint32_t>();
        if (n > remaining_ / bytesEach) {
            throw PeerError("it announces " + std::to_string(n) + " values, but only " +
                            std::to_string(remaining_) + " bytes follow");
        }
        return n;
    }

    std::uint8_t enumerator(std::uint8_t largest, const char* what) {
        const auto value = littleEndian<std::uint8_t>();
        if (value > largest) {
            throw PeerError(std::to_string(value) + " is not " + what);
        }
        return value;
    }

    template <class Unsigned>
    Unsigned littleEndian() {
        if (remaining_ < sizeof(Unsigned)) {
            throw PeerError("it is too short");
        }
        Unsigned value = 0;
        for (std::size_t i = 0; i < sizeof value; ++i) {
            value |= static_cast<Unsigned>(static_cast<Unsigned>(next_[i]) << (8 * i));
        }
        advance(sizeof value);
        return value;
    }

    void advance(std::size_t n) {
        next_ += n;
        remaining_ -= n;
    }

    const std::uint8_t* next_;
    std::size_t remaining_;
};

} // namespace tokay::channel
