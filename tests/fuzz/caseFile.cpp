// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/fuzz.hpp"
#include "igaStructure/case/readCase.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return tokay::fuzz::run(
        [&] { tokay::structure::readCase(tokay::fuzz::fileOf(data, size, ".yaml")); });
}
