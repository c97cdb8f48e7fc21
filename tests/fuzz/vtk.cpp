// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/fuzz.hpp"
#include "tokayMap/files/readVtk.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return tokay::fuzz::run([&] { tokay::tool::readVtk(tokay::fuzz::fileOf(data, size, ".vtu")); });
}
