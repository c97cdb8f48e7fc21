// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/shakeHands.hpp"
#include "connectedPair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

namespace tokay::channel {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const Hello fluidHello{protocolVersion, Role::fluid, "pimpleFoam", "pa55word", ""};
const Hello structureHello{protocolVersion, Role::structure, "igaStructure", "pa55word", "a3f8"};

struct Errors {
    std::string fluid;
    std::string structure;
};

/// What each side's handshake throws.
Errors errorsOfHandshake(const Hello& fluid, const Hello& structure) {
    auto [fluidEnd, structureEnd] = connectedPair();
    auto other = std::async(std::launch::async, [&, &end = structureEnd] {
        return errorOf<PeerError>([&] { shakeHands(end, structure); });
    });
    const std::string error = errorOf<PeerError>([&, &end = fluidEnd] { shakeHands(end, fluid); });
    return {error, other.get()};
}

TEST(ShakeHands, introducesBothSides) {
    auto [fluid, structure] = connectedPair();
    auto other = std::async(std::launch::async,
                            [&end = structure] { return shakeHands(end, structureHello); });
    const Hello answer = shakeHands(fluid, fluidHello);
    EXPECT_EQ(answer.program, "igaStructure");
    EXPECT_EQ(answer.caseDigest, "a3f8");
    EXPECT_EQ(other.get().program, "pimpleFoam");
    EXPECT_EQ(fluid.peer(), "the structure");
    EXPECT_EQ(structure.peer(), "the fluid");
}

TEST(ShakeHands, wrongTokenIsToldToBothSidesAndNotShown) {
    for (const char* token : {"", "pa55word!", "pa55wor", "Pa55word", "pa55wordpa55word"}) {
        Hello fluid = fluidHello;
        fluid.token = token;
        const Errors errors = errorsOfHandshake(fluid, structureHello);
        EXPECT_THAT(errors.structure, HasSubstr("the fluid gave a wrong token")) << token;
        EXPECT_THAT(errors.fluid, AllOf(HasSubstr("wrong token"), Not(HasSubstr("a55wor"))));
    }
}

TEST(ShakeHands, structureWithAWrongTokenIsRefusedToo) {
    Hello structure = structureHello;
    structure.token = "";
    Hello fluid = fluidHello;
    EXPECT_THAT(errorsOfHandshake(fluid, structure).structure, HasSubstr("wrong token"));
}

TEST(ShakeHands, strangerNeverSeesTheToken) {
    auto [stranger, structure] = connectedPair();
    stranger.send(Hello{protocolVersion, Role::fluid, "stranger", "guess", ""});
    EXPECT_THROW(shakeHands(structure, structureHello), PeerError);
    EXPECT_THROW(stranger.receive("anything but a Hello"), PeerFailure);
}

TEST(ShakeHands, otherProtocolVersionIsToldToBothSidesNamingBoth) {
    Hello newer = fluidHello;
    newer.protocol = 42;
    const Errors errors = errorsOfHandshake(newer, structureHello);
    EXPECT_THAT(errors.structure, AllOf(HasSubstr("version 42"), HasSubstr("version 2")));
    EXPECT_THAT(errors.fluid, AllOf(HasSubstr("version 42"), HasSubstr("version 2")));
}

TEST(ShakeHands, twoFluidsAreRefused) {
    const Errors errors = errorsOfHandshake(fluidHello, fluidHello);
    EXPECT_THAT(errors.fluid + errors.structure, HasSubstr("both sides are the fluid"));
}

TEST(ShakeHands, anotherMessageThanAGreetingIsRefused) {
    auto [stranger, structure] = connectedPair();
    stranger.send(BeginStep{1, 0.1, 0.1});
    EXPECT_THAT(errorOf<PeerError>([&end = structure] { shakeHands(end, structureHello); }),
                HasSubstr("BeginStep"));
}

} // namespace
} // namespace tokay::channel
