// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"

#include "fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return tokay::fuzz::run(
        [&] { tokay::geometry::readCadJson(tokay::fuzz::fileOf(data, size, ".cad.json")); });
}
