// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/PeerError.hpp"
#include "channel/encoding.hpp"
#include "fuzz/fuzz.hpp"

#include <algorithm>

// A message from its type, the first byte, and its payload.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tokay::channel;
    if (size == 0) {
        return 0;
    }
    FrameHeader header;
    header.type = data[0] % std::variant_size_v<Message>;
    header.payloadLength = static_cast<std::uint32_t>(size - 1);
    return tokay::fuzz::run([&] {
        try {
            decodePayload(header, Bytes(data + 1, data + size));
        } catch (const PeerError&) {
        }
    });
}
