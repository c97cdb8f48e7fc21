// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

namespace tokay::fuzz {

/// Writes the input to a file of this process, for readers that take a path.
inline std::string fileOf(const std::uint8_t* data, std::size_t size, const std::string& ending) {
    static const std::string stem = "/dev/shm/tokayFuzz" + std::to_string(getpid());
    const std::string path = stem + ending;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path;
}

/// Runs a reader; an InputError is its right way to refuse an input, anything else a
/// finding.
template <class Read>
int run(const Read& read) {
    try {
        read();
    } catch (const InputError&) {
    }
    return 0;
}

} // namespace tokay::fuzz
