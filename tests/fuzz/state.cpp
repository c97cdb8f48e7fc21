// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/checksum.hpp"
#include "fuzz/fuzz.hpp"
#include "igaStructure/coupledRun/restart/SavedState.hpp"

// As it is, and with the checksum that it needs to be read at all.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using tokay::structure::decodeState;
    std::vector<std::uint8_t> bytes(data, data + size);
    tokay::fuzz::run([&] { decodeState(bytes, "input"); });
    const std::uint32_t sum = tokay::checksum(data, size);
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(sum >> shift));
    }
    return tokay::fuzz::run([&] { decodeState(bytes, "input"); });
}
