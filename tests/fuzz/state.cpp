// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/fuzz.hpp"
#include "igaStructure/coupledRun/restart/SavedState.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return tokay::fuzz::run([&] {
        tokay::structure::decodeState(std::vector<std::uint8_t>(data, data + size), "input");
    });
}
