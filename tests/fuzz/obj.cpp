// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/fuzz.hpp"
#include "tokayMap/files/readObj.hpp"
#include "tokayMap/files/readValues.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string path = tokay::fuzz::fileOf(data, size, ".obj");
    tokay::fuzz::run([&] { tokay::tool::readValues(path); });
    return tokay::fuzz::run([&] { tokay::tool::readObj(path); });
}
