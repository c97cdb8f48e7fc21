// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace tokay {

/// CRC-32 of a block of bytes, as zlib has it: finds every damage to up to 32 bits
/// in a row, and all but one in four thousand million of others; no protection
/// against intent.
/// @param before  that of the bytes before these, to continue; 0 at the beginning
std::uint32_t checksum(const void* data, std::size_t size, std::uint32_t before = 0);

inline std::uint32_t checksum(const std::string& text, std::uint32_t before = 0) {
    return checksum(text.data(), text.size(), before);
}

} // namespace tokay
