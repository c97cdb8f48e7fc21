// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/connectedPair.hpp"
#include "channel/handshake/Handshake.hpp"
#include "channel/handshake/proof.hpp"
#include "channel/handshake/shakeHands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace tokay::channel {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const Hello fluidHello{protocolVersion, Role::fluid, "pimpleFoam", ""};
const Hello structureHello{protocolVersion, Role::structure, "igaStructure", "a3f8"};
const std::string token = "pa55word";

struct Errors {
    std::string fluid;
    std::string structure;
};

/// What each side's handshake throws.
Errors errorsOfHandshake(const Hello& fluid, const Hello& structure,
                         const std::string& ofFluid = token,
                         const std::string& ofStructure = token) {
    auto [fluidEnd, structureEnd] = connectedPair();
    auto other = std::async(std::launch::async, [&, &end = structureEnd] {
        return errorOf<PeerError>([&] { shakeHands(end, structure, ofStructure); });
    });
    const std::string error =
        errorOf<PeerError>([&, &end = fluidEnd] { shakeHands(end, fluid, ofFluid); });
    return {error, other.get()};
}

TEST(ShakeHands, introduces_both_sides) {
    auto [fluid, structure] = connectedPair();
    auto other = std::async(std::launch::async,
                            [&end = structure] { return shakeHands(end, structureHello, token); });
    const Hello answer = shakeHands(fluid, fluidHello, token);
    EXPECT_EQ(answer.program, "igaStructure");
    EXPECT_EQ(answer.caseDigest, "a3f8");
    EXPECT_EQ(other.get().program, "pimpleFoam");
    EXPECT_EQ(fluid.peer(), "the structure");
    EXPECT_EQ(structure.peer(), "the fluid");
}

TEST(ShakeHands, a_moved_structure_has_the_fluids_part) {
    const Hello moved{protocolVersion, Role::movedStructure, "igaStructure", ""};
    auto [leading, structure] = connectedPair();
    auto other = std::async(std::launch::async,
                            [&end = structure] { return shakeHands(end, structureHello, token); });
    shakeHands(leading, moved, token);
    EXPECT_EQ(other.get().role, Role::movedStructure);
    EXPECT_EQ(structure.peer(), "the moved structure");
    EXPECT_THAT(errorsOfHandshake(moved, structureHello, "guess").structure,
                HasSubstr("the moved structure gave a wrong token"));
    EXPECT_THAT(errorsOfHandshake(fluidHello, moved).fluid,
                HasSubstr("connect each to a structure that is loaded"));
}

TEST(ShakeHands, wrong_token_is_told_to_both_sides_and_not_shown) {
    for (const char* given : {"", "pa55word!", "pa55wor", "Pa55word", "pa55wordpa55word"}) {
        const Errors errors = errorsOfHandshake(fluidHello, structureHello, given);
        EXPECT_THAT(errors.structure, HasSubstr("the fluid gave a wrong token")) << given;
        EXPECT_THAT(errors.fluid, AllOf(HasSubstr("wrong token"), Not(HasSubstr("a55wor"))));
    }
}

TEST(ShakeHands, structure_with_a_wrong_token_is_refused_too) {
    EXPECT_THAT(errorsOfHandshake(fluidHello, structureHello, token, "").structure,
                HasSubstr("wrong token"));
}

/// Both sides' messages of a handshake, in their order.
std::vector<Message> conversation() {
    Handshake fluid(fluidHello, token);
    Handshake structure(structureHello, token);
    std::vector<Message> messages = {*fluid.begin()};
    for (int i = 0; i < 3; ++i) {
        Handshake& receiver = i % 2 == 0 ? structure : fluid;
        messages.push_back(*receiver.answer(messages.back()));
    }
    EXPECT_FALSE(fluid.answer(messages.back()).has_value());
    EXPECT_TRUE(fluid.isComplete() && structure.isComplete());
    return messages;
}

TEST(ShakeHands, token_is_never_sent) {
    for (const Message& message : conversation()) {
        const Bytes frame = encodeFrame(message);
        EXPECT_THAT(std::string(frame.begin(), frame.end()), Not(HasSubstr(token)));
    }
}

TEST(ShakeHands, every_handshake_has_other_nonces_and_proofs) {
    const std::vector<Message> one = conversation();
    const std::vector<Message> other = conversation();
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_NE(encodeFrame(one[i]), encodeFrame(other[i])) << i;
    }
}

TEST(ShakeHands, what_was_heard_in_an_earlier_handshake_opens_none) {
    const std::vector<Message> heard = conversation();
    Handshake structure(structureHello, token);
    structure.answer(heard[0]);
    EXPECT_THAT(errorOf<PeerError>([&] { structure.answer(heard[2]); }),
                HasSubstr("the fluid gave a wrong token"));
    Handshake fluid(fluidHello, token);
    fluid.answer(heard[1]);
    EXPECT_THAT(errorOf<PeerError>([&] { fluid.answer(heard[3]); }),
                HasSubstr("the structure gave a wrong token"));
}

TEST(ShakeHands, fluid_believes_no_structure_that_does_not_know_the_token) {
    Handshake fluid(fluidHello, token);
    const auto greeting = std::get<Hello>(*fluid.begin());
    const auto proof = std::get<Proof>(*fluid.answer(structureHello));
    EXPECT_THROW(fluid.answer(Proof{}), PeerError);
    EXPECT_THROW(fluid.answer(proof), PeerError); // its own, sent back
    EXPECT_THROW(fluid.answer(proofOf(Role::structure, "guess", greeting, structureHello)),
                 PeerError);
    EXPECT_FALSE(fluid.isComplete());
    fluid.answer(proofOf(Role::structure, token, greeting, structureHello));
    EXPECT_TRUE(fluid.isComplete());
}

TEST(ShakeHands, stranger_sees_nothing_that_the_token_has_touched) {
    auto [stranger, structure] = connectedPair();
    auto other = std::async(std::launch::async, [&end = structure] {
        return errorOf<PeerError>([&] { shakeHands(end, structureHello, token); });
    });
    stranger.send(fluidHello);
    EXPECT_TRUE(std::holds_alternative<Hello>(stranger.receive("a greeting")));
    stranger.send(Proof{});
    EXPECT_THROW(stranger.receive("anything but a proof"), PeerFailure);
    EXPECT_THAT(other.get(), HasSubstr("wrong token"));
}

TEST(HmacSha256, is_that_of_rfc4231) {
    const auto hex = [](const std::array<std::uint8_t, 32>& digest) {
        std::string text;
        for (const std::uint8_t byte : digest) {
            text += "0123456789abcdef"[byte >> 4];
            text += "0123456789abcdef"[byte & 15];
        }
        return text;
    };
    const std::string hiThere = "Hi There";
    EXPECT_EQ(hex(hmacSha256(std::string(20, '\x0b'), {hiThere.begin(), hiThere.end()})),
              "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    const std::string question = "what do ya want for nothing?";
    EXPECT_EQ(hex(hmacSha256("Jefe", {question.begin(), question.end()})),
              "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

TEST(ShakeHands, other_protocol_version_is_told_to_both_sides_naming_both) {
    Hello newer = fluidHello;
    newer.protocol = 42;
    const Errors errors = errorsOfHandshake(newer, structureHello);
    const auto namesBoth =
        AllOf(HasSubstr("version 42"), HasSubstr("version " + std::to_string(protocolVersion)));
    EXPECT_THAT(errors.structure, namesBoth);
    EXPECT_THAT(errors.fluid, namesBoth);
}

TEST(ShakeHands, two_fluids_are_refused) {
    const Errors errors = errorsOfHandshake(fluidHello, fluidHello);
    EXPECT_THAT(errors.fluid + errors.structure, HasSubstr("both sides are the fluid"));
}

TEST(ShakeHands, another_message_than_a_greeting_is_refused) {
    auto [stranger, structure] = connectedPair();
    stranger.send(BeginStep{1, 0.1, 0.1});
    EXPECT_THAT(errorOf<PeerError>([&end = structure] { shakeHands(end, structureHello); }),
                HasSubstr("BeginStep"));
}

} // namespace
} // namespace tokay::channel
