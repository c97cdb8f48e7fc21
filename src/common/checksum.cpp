// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/checksum.hpp"

#include <zlib.h>

namespace tokay {

std::uint32_t checksum(const void* data, std::size_t size, std::uint32_t before) {
    return static_cast<std::uint32_t>(crc32_z(before, static_cast<const Bytef*>(data), size));
}

} // namespace tokay
