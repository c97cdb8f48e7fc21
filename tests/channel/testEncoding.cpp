// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/PeerError.hpp"
#include "channel/encoding.hpp"
#include "exampleMessages.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tokay::channel {
namespace {

Message decodeFrame(const Bytes& frame) {
    std::array<std::uint8_t, FrameHeader::size> head;
    if (frame.size() < head.size()) {
        throw PeerError("the frame ends in its header");
    }
    std::copy_n(frame.begin(), head.size(), head.begin());
    const FrameHeader header = decodeHeader(head);
    const Bytes payload(frame.begin() + FrameHeader::size, frame.end());
    if (payload.size() != header.payloadLength) {
        throw PeerError("the payload has another length than announced");
    }
    return decodePayload(header, payload);
}

/// Sets the payload length that the header announces.
void setLength(Bytes& frame, std::uint32_t length) {
    for (std::size_t i = 0; i < 4; ++i) {
        frame[12 + i] = static_cast<std::uint8_t>(length >> (8 * i));
    }
}

std::string errorOf(const Bytes& frame) {
    try {
        decodeFrame(frame);
    } catch (const PeerError& error) {
        return error.what();
    }
    return "";
}

long peakMemoryInKilobytes() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

template <class M>
M roundTrip(const M& message) {
    return std::get<M>(decodeFrame(encodeFrame(message)));
}

template <class M>
M example() {
    for (const Message& message : exampleMessages()) {
        if (const M* found = std::get_if<M>(&message)) {
            return *found;
        }
    }
    throw std::logic_error("no example of this type");
}

TEST(Encoding, hello_survives_the_round_trip) {
    const Hello result = roundTrip(example<Hello>());
    EXPECT_EQ(result.protocol, protocolVersion);
    EXPECT_EQ(result.role, Role::structure);
    EXPECT_EQ(result.program, "igaStructure 0.1");
    EXPECT_EQ(result.caseDigest, "a3f8");
    EXPECT_EQ(result.nonce, example<Hello>().nonce);
    EXPECT_EQ(roundTrip(example<Proof>()).digest, example<Proof>().digest);
}

TEST(Encoding, interface_survives_the_round_trip) {
    const Interface sent = exampleInterface();
    const Interface result = roundTrip(sent);
    EXPECT_EQ(result.dimension, sent.dimension);
    EXPECT_EQ(result.name, sent.name);
    EXPECT_EQ(result.points, sent.points);
    EXPECT_EQ(result.faceOffsets, sent.faceOffsets);
    EXPECT_EQ(result.facePoints, sent.facePoints);
    EXPECT_EQ(result.displacements, sent.displacements);
    EXPECT_EQ(result.tolerance, sent.tolerance);
    EXPECT_EQ(result.startTime, sent.startTime);
    EXPECT_EQ(result.endTime, sent.endTime);
    EXPECT_EQ(result.deltaT, sent.deltaT);
    EXPECT_EQ(result.retries, sent.retries);
}

TEST(Encoding, messages_of_a_step_survive_the_round_trip) {
    const BeginStep begin = roundTrip(example<BeginStep>());
    EXPECT_EQ(begin.step, 12u);
    EXPECT_EQ(begin.time, 0.75);
    EXPECT_EQ(begin.deltaT, 1e-3);
    const Forces forces = roundTrip(example<Forces>());
    EXPECT_TRUE(forces.final);
    EXPECT_TRUE(forces.write);
    EXPECT_EQ(forces.fluidResidual, 3e-5);
    EXPECT_EQ(roundTrip(Forces{}).fluidResidual, std::nullopt);
    EXPECT_EQ(forces.values, example<Forces>().values);
    EXPECT_EQ(forces.fluidTimes, example<Forces>().fluidTimes);
    const Displacements displacements = roundTrip(example<Displacements>());
    EXPECT_EQ(displacements.state, State::rejected);
    EXPECT_EQ(displacements.reason, "no equilibrium");
    EXPECT_EQ(displacements.residual, 2e-5);
    EXPECT_EQ(displacements.values, (std::vector<double>{0.1, 0.2}));
    EXPECT_TRUE(roundTrip(example<Accepted>()).limitsForce);
}

TEST(Encoding, texts_survive_the_round_trip) {
    EXPECT_EQ(roundTrip(example<Accepted>()).report, example<Accepted>().report);
    EXPECT_EQ(roundTrip(example<Goodbye>()).reason, example<Goodbye>().reason);
    EXPECT_EQ(roundTrip(example<Failure>()).text, example<Failure>().text);
}

TEST(Encoding, is_little_endian_on_every_machine) {
    const Bytes expected = {'T',  'o',  'k',  'a',  5,  0, 0,    0,
                            3,    0,    0,    0,    20, 0, 0,    0,     // header
                            0x04, 0x03, 0x02, 0x01,                     // step
                            0,    0,    0,    0,    0,  0, 0xf0, 0x3f,  // time 1
                            0,    0,    0,    0,    0,  0, 0,    0xc0}; // deltaT -2
    EXPECT_EQ(encodeFrame(BeginStep{0x01020304, 1, -2}), expected);
}

TEST(Encoding, every_truncation_of_every_message_is_refused) {
    for (const Message& message : exampleMessages()) {
        const Bytes frame = encodeFrame(message);
        for (std::size_t length = FrameHeader::size; length < frame.size(); ++length) {
            Bytes truncated(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(length));
            setLength(truncated, static_cast<std::uint32_t>(length - FrameHeader::size));
            EXPECT_NE(errorOf(truncated).find(typeName(message.index())), std::string::npos)
                << typeName(message.index()) << " cut to " << length << " bytes";
        }
    }
}

TEST(Encoding, trailing_bytes_are_refused) {
    for (const Message& message : exampleMessages()) {
        Bytes frame = encodeFrame(message);
        frame.push_back(0);
        setLength(frame, static_cast<std::uint32_t>(frame.size() - FrameHeader::size));
        EXPECT_NE(errorOf(frame).find("1 bytes follow its end"), std::string::npos);
    }
}

/// Where a flip has made a control character of a letter, a question mark stands for it.
void expectSameButForUnprintable(const Bytes& result, const Bytes& frame) {
    ASSERT_EQ(result.size(), frame.size());
    for (std::size_t i = 0; i < frame.size(); ++i) {
        EXPECT_TRUE(result[i] == frame[i] || result[i] == '?') << i;
    }
}

TEST(Encoding, whatever_is_accepted_after_a_flipped_bit_encodes_to_the_same_bytes) {
    // So no two byte strings mean the same, and nothing is read half.
    int nRefused = 0;
    for (const Message& message : exampleMessages()) {
        const Bytes frame = encodeFrame(message);
        for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
            Bytes flipped = frame;
            flipped[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
            try {
                expectSameButForUnprintable(encodeFrame(decodeFrame(flipped)), flipped);
            } catch (const PeerError&) {
                ++nRefused;
            }
        }
    }
    EXPECT_GT(nRefused, 8 * 8 * 12); // at least every bit of every header but the types'
}

TEST(Encoding, random_bytes_behind_a_valid_header_never_do_harm) {
    std::mt19937 random(20240611);
    const long before = peakMemoryInKilobytes();
    for (int i = 0; i < 20000; ++i) {
        FrameHeader header;
        header.type = random() % std::variant_size_v<Message>;
        Bytes payload(random() % 64);
        // Many small and many huge lengths: bytes are mostly 0 or 255.
        std::generate(payload.begin(), payload.end(), [&random] {
            const auto value = random();
            return static_cast<std::uint8_t>(value % 3 == 0   ? value >> 8
                                             : value % 3 == 1 ? 0
                                                              : 255);
        });
        header.payloadLength = static_cast<std::uint32_t>(payload.size());
        try {
            decodePayload(header, payload);
        } catch (const PeerError&) {
        }
    }
    // The smallest false array (16 million doubles) would take twice as much.
    EXPECT_LT(peakMemoryInKilobytes() - before, 64 * 1024);
}

TEST(Encoding, other_magic_is_refused_as_another_program) {
    Bytes frame = encodeFrame(Goodbye{"end"});
    const std::string http = "GET / HTTP/1.1\r\n";
    std::copy(http.begin(), http.end(), frame.begin());
    EXPECT_NE(errorOf(frame).find("not a message of Tokay"), std::string::npos);
}

TEST(Encoding, other_protocol_version_is_refused_naming_both) {
    Bytes frame = encodeFrame(Goodbye{"end"});
    frame[4] = 7;
    const std::string error = errorOf(frame);
    EXPECT_NE(error.find("version 7"), std::string::npos) << error;
    EXPECT_NE(error.find("version " + std::to_string(protocolVersion)), std::string::npos) << error;
}

TEST(Encoding, unknown_type_is_refused) {
    Bytes frame = encodeFrame(Goodbye{"end"});
    frame[8] = 99;
    EXPECT_NE(errorOf(frame).find("unknown type 99"), std::string::npos);
}

TEST(Encoding, oversize_length_is_refused_by_the_header_alone) {
    Bytes frame = encodeFrame(Goodbye{"end"});
    setLength(frame, largestPayload + 1);
    EXPECT_NE(errorOf(frame).find("more than the limit"), std::string::npos);
}

TEST(Encoding, interface_with_arrays_that_do_not_fit_is_refused) {
    const auto errorAfter = [](auto change) {
        Interface interface = exampleInterface();
        change(interface);
        return errorOf(encodeFrame(interface));
    };
    EXPECT_NE(errorAfter([](Interface& i) { i.dimension = 4; }).find("dimension is 4"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.points.pop_back(); }).find("whole points"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.displacements.clear(); }).find("one displacement"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.facePoints[4] = 4; }).find("point 4 of 4"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.faceOffsets[1] = 7; }).find("faces"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.faceOffsets.clear(); }).find("faces"),
              std::string::npos);
}

TEST(Encoding, interface_with_numbers_that_are_not_finite_is_refused) {
    const auto errorAfter = [](auto change) {
        Interface interface = exampleInterface();
        change(interface);
        return errorOf(encodeFrame(interface));
    };
    EXPECT_NE(errorAfter([](Interface& i) {
                  i.points[4] = std::nan("");
              }).find("a coordinate of its points is not finite, component 4 of 12"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) {
                  i.displacements[2] = 1 / 0.0;
              }).find("a displacement of its points is not finite, component 2"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.startTime = std::nan(""); }).find("starts at nan s"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) { i.deltaT = -1; }).find("time step is -1 s"),
              std::string::npos);
    EXPECT_NE(errorAfter([](Interface& i) {
                  i.facePoints.clear(), i.faceOffsets = {0};
              }).find("has no faces"),
              std::string::npos);
}

TEST(Encoding, no_control_character_of_a_text_reaches_the_terminal) {
    EXPECT_EQ(roundTrip(Failure{"a\x1b[2J\x07\r\n\tb\x9b"}).text, "a?[2J??\n\tb?");
    EXPECT_EQ(roundTrip(Accepted{"\x1b]0;title", false}).report, "?]0;title");
    EXPECT_EQ(roundTrip(Displacements{State::rejected, 1, {}, "\b\b"}).reason, "??");
    EXPECT_EQ(roundTrip(Goodbye{std::string("\0\x7f", 2)}).reason, "??");
    EXPECT_EQ(roundTrip(RejectStep{"Jörg, St. Venant–Kirchhoff"}).reason,
              "Jörg, St. Venant–Kirchhoff");
}

TEST(Encoding, name_of_a_program_that_is_no_line_is_refused) {
    Hello hello = example<Hello>();
    hello.program = "igaStructure\nstep 1 time 0.1 s";
    EXPECT_NE(errorOf(encodeFrame(hello)).find("is no short line"), std::string::npos);
    hello.program = std::string(1000, 'x');
    EXPECT_NE(errorOf(encodeFrame(hello)).find("is no short line"), std::string::npos);
}

} // namespace
} // namespace tokay::channel
