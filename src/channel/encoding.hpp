// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tokay::channel {

using Bytes = std::vector<std::uint8_t>;

/// What precedes each payload; 4 x uint32, little-endian, with the magic.
struct FrameHeader {
    static constexpr std::size_t size = 16;
    std::uint32_t protocol = protocolVersion;
    std::uint32_t type = 0; ///< index in Message
    std::uint32_t payloadLength = 0;
};

/// No payload is larger: 1 GiB, about 40 million points.
constexpr std::uint32_t largestPayload = 1u << 30;

/// Before the handshake, what a stranger may make us read.
constexpr std::uint32_t largestPayloadOfStranger = 1u << 16;

/// "Hello", "Interface", …
const char* typeName(std::size_t type);

/// Header and payload. A Hello travels under its own protocol version.
/// @throws InputError if the payload would exceed largestPayload
Bytes encodeFrame(const Message& message);

/// @param limit  largest payload that the caller is ready to read
/// @throws PeerError on another magic, protocol version, an unknown type or a
///         payload longer than the limit
FrameHeader decodeHeader(const std::array<std::uint8_t, FrameHeader::size>& bytes,
                         std::uint32_t limit = largestPayload);

/// Every length is checked against the bytes that remain before anything is
/// allocated. Control characters in texts become question marks.
/// @param payload  of header.payloadLength bytes
/// @throws PeerError if the payload is not exactly one message of this type
Message decodePayload(const FrameHeader& header, const Bytes& payload);

} // namespace tokay::channel
