// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/encoding.hpp"

#include "channel/ByteReader.hpp"
#include "channel/ByteWriter.hpp"
#include "channel/messageChecks.hpp"
#include "channel/printable.hpp"
#include "common/errors.hpp"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace tokay::channel {
namespace {

constexpr std::array<std::uint8_t, 4> magic = {'T', 'o', 'k', 'a'};

constexpr std::array<const char*, std::variant_size_v<Message>> typeNames = {
    "Hello",         "Interface", "Accepted", "BeginStep",  "Forces",
    "Displacements", "Goodbye",   "Failure",  "RejectStep", "Proof"};

/// The fields of a message in their order on the wire, for both directions.
/// (The protocol version of a Hello stands in the frame's header.)
template <class M>
auto fieldsOf(M& m) {
    using Type = std::remove_const_t<M>;
    if constexpr (std::is_same_v<Type, Hello>) {
        return std::tie(m.role, m.program, m.caseDigest, m.nonce);
    } else if constexpr (std::is_same_v<Type, Interface>) {
        return std::tie(m.dimension, m.name, m.points, m.faceOffsets, m.facePoints, m.displacements,
                        m.tolerance, m.startTime, m.endTime, m.deltaT, m.retries, m.audit);
    } else if constexpr (std::is_same_v<Type, Accepted>) {
        return std::tie(m.report, m.limitsForce);
    } else if constexpr (std::is_same_v<Type, BeginStep>) {
        return std::tie(m.step, m.time, m.deltaT);
    } else if constexpr (std::is_same_v<Type, Forces>) {
        return std::tie(m.final, m.write, m.fluidResidual, m.values, m.ifConverged, m.fluidTimes);
    } else if constexpr (std::is_same_v<Type, Displacements>) {
        return std::tie(m.state, m.residual, m.values, m.reason, m.balance);
    } else if constexpr (std::is_same_v<Type, Goodbye>) {
        return std::tie(m.reason);
    } else if constexpr (std::is_same_v<Type, RejectStep>) {
        return std::tie(m.reason);
    } else if constexpr (std::is_same_v<Type, Proof>) {
        return std::tie(m.digest);
    } else {
        static_assert(std::is_same_v<Type, Failure>);
        return std::tie(m.text);
    }
}

template <class Archive, class M>
void visitFields(Archive& archive, M& message) {
    std::apply([&](auto&... field) { (archive(field), ...); }, fieldsOf(message));
}

/// Texts end on a terminal.
struct MakePrintable {
    void operator()(std::string& text) const { text = printable(std::move(text)); }
    template <class Value>
    void operator()(Value& /*value*/) const {}
};

template <std::size_t Type>
Message decodeAs(const FrameHeader& header, const Bytes& payload) {
    std::variant_alternative_t<Type, Message> message;
    ByteReader reader(payload.data(), payload.size());
    visitFields(reader, message);
    if (reader.remaining() != 0) {
        throw PeerError(std::to_string(reader.remaining()) + " bytes follow its end");
    }
    if constexpr (std::is_same_v<decltype(message), Hello>) {
        message.protocol = header.protocol;
        requireConsistent(message);
    }
    if constexpr (std::is_same_v<decltype(message), Interface>) {
        requireConsistent(message);
    }
    const MakePrintable makePrintable;
    visitFields(makePrintable, message);
    return message;
}

template <std::size_t... Types>
Message decodeAny(const FrameHeader& header, const Bytes& payload, std::index_sequence<Types...>) {
    Message message;
    const bool known =
        ((header.type == Types && (message = decodeAs<Types>(header, payload), true)) || ...);
    if (!known) {
        throw PeerError("its type " + std::to_string(header.type) + " is unknown");
    }
    return message;
}

std::uint32_t protocolOf(const Message& message) {
    const auto* hello = std::get_if<Hello>(&message);
    return hello ? hello->protocol : protocolVersion;
}

} // namespace

const char* typeName(std::size_t type) {
    return typeNames.at(type);
}

Bytes encodeFrame(const Message& message) {
    Bytes payload;
    ByteWriter writePayload(payload);
    std::visit([&](const auto& m) { visitFields(writePayload, m); }, message);
    if (payload.size() > largestPayload) {
        throw InputError(std::string("A message of type ") + typeName(message.index()) + " needs " +
                         std::to_string(payload.size()) + " bytes, more than the limit of " +
                         std::to_string(largestPayload) +
                         ": give the coupled interface fewer points or faces.");
    }
    Bytes frame(magic.begin(), magic.end());
    frame.reserve(FrameHeader::size + payload.size());
    ByteWriter write(frame);
    write(protocolOf(message));
    write(static_cast<std::uint32_t>(message.index()));
    write(static_cast<std::uint32_t>(payload.size()));
    frame.insert(frame.end(), payload.begin(), payload.end());
    return frame;
}

FrameHeader decodeHeader(const std::array<std::uint8_t, FrameHeader::size>& bytes,
                         std::uint32_t limit) {
    if (!std::equal(magic.begin(), magic.end(), bytes.begin())) {
        throw PeerError("what arrived is not a message of Tokay; is another program on this "
                        "connection?");
    }
    FrameHeader header;
    ByteReader reader(bytes.data() + magic.size(), bytes.size() - magic.size());
    reader(header.protocol);
    reader(header.type);
    reader(header.payloadLength);
    if (header.protocol != protocolVersion) {
        throw PeerError("protocol version " + std::to_string(header.protocol) +
                        " arrived, this side speaks version " + std::to_string(protocolVersion) +
                        ": install the same Tokay on both sides");
    }
    if (header.type >= typeNames.size()) {
        throw PeerError("a message of the unknown type " + std::to_string(header.type) +
                        " arrived");
    }
    if (header.payloadLength > limit) {
        throw PeerError(std::string("a message of type ") + typeName(header.type) + " announces " +
                        std::to_string(header.payloadLength) + " bytes, more than the limit of " +
                        std::to_string(limit));
    }
    return header;
}

Message decodePayload(const FrameHeader& header, const Bytes& payload) {
    try {
        return decodeAny(header, payload, std::make_index_sequence<std::variant_size_v<Message>>());
    } catch (const PeerError& error) {
        throw PeerError(std::string("a malformed message of type ") + typeName(header.type) +
                        " arrived: " + error.what());
    }
}

} // namespace tokay::channel
