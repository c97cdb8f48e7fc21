// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/messageChecks.hpp"
#include "channel/printable.hpp"
#include "connectedPair.hpp"
#include "exampleMessages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tokay::channel {
namespace {

using ::testing::HasSubstr;

const Message begin = BeginStep{1, 0.1, 0.1};
const Message forces = Forces{};
const Message finalForces = Forces{true, false, 0, {}};

/// That of a structure which has nothing to hide.
Displacements answerOf(State state) {
    Displacements answer;
    answer.state = state;
    answer.residual = state == State::iterate ? 0.5 : 1e-5;
    answer.values.assign(12, 0.25);
    return answer;
}

std::string refusal(const Displacements& answer, const Message& question = forces) {
    return errorOf<PeerError>(
        [&] { requireUsable(answer, question, Agreement(exampleInterface())); });
}

TEST(Answer, that_the_question_allows_is_used) {
    EXPECT_EQ(refusal(answerOf(State::iterate), begin), "");
    for (const State state : {State::iterate, State::converged, State::rejected}) {
        EXPECT_EQ(refusal(answerOf(state), forces), "");
    }
    for (const State state : {State::accepted, State::rejected}) {
        EXPECT_EQ(refusal(answerOf(state), finalForces), "");
    }
}

TEST(Answer, that_goes_on_where_only_a_converged_step_ends_is_used) {
    const Message ifConverged = Forces{true, false, 0, {}, true};
    for (const State state : {State::iterate, State::converged, State::accepted, State::rejected}) {
        EXPECT_EQ(refusal(answerOf(state), ifConverged), "");
    }
}

TEST(Answer, of_a_state_that_the_question_does_not_allow_is_refused) {
    for (const State state : {State::converged, State::accepted, State::rejected}) {
        EXPECT_THAT(refusal(answerOf(state), begin), HasSubstr("to the begin of a time step"));
    }
    EXPECT_THAT(refusal(answerOf(State::accepted), forces), HasSubstr("'accepted' to forces"));
    for (const State state : {State::iterate, State::converged}) {
        EXPECT_THAT(refusal(answerOf(state), finalForces), HasSubstr("to final forces"));
    }
}

TEST(Answer, that_says_converged_with_a_residual_above_the_tolerance_is_refused) {
    Displacements answer = answerOf(State::converged);
    for (const double residual : {1e5, 1e-4}) {
        answer.residual = residual;
        EXPECT_THAT(refusal(answer), HasSubstr("at a tolerance of 0.0001"));
    }
}

TEST(Answer, with_a_residual_that_is_none_is_refused) {
    for (const double residual : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        for (const State state : {State::iterate, State::converged}) {
            Displacements answer = answerOf(state);
            answer.residual = residual;
            EXPECT_THAT(refusal(answer), HasSubstr("coupling residual is ")) << residual;
        }
    }
}

TEST(Answer, with_other_than_one_finite_displacement_a_component_is_refused) {
    Displacements answer = answerOf(State::iterate);
    answer.values.pop_back();
    EXPECT_THAT(refusal(answer, begin),
                HasSubstr("sent 11 displacement components where the interface has 12"));
    answer = answerOf(State::accepted);
    answer.values[3] = std::nan("");
    EXPECT_THAT(refusal(answer, finalForces), HasSubstr("is not finite, component 3 of 12"));
}

TEST(Answer, that_is_a_million_times_the_interface_away_is_refused) {
    Displacements answer = answerOf(State::iterate);
    answer.values[5] = -0.9e6;
    EXPECT_EQ(refusal(answer), ""); // the interface is 1 m long
    answer.values[5] = -1e300;
    EXPECT_THAT(refusal(answer), HasSubstr("displacement is -1e+300 m at an interface of 1 m"));
}

TEST(Answer, with_a_balance_that_is_not_finite_is_refused) {
    Displacements answer = answerOf(State::accepted);
    answer.balance = InterfaceBalance{{1, 2, 3}, {4, 5, 6}, 7, std::nan("")};
    EXPECT_THAT(refusal(answer, finalForces), HasSubstr("swept volume is not finite"));
}

TEST(Printable, replaces_what_a_terminal_obeys_byte_for_byte) {
    EXPECT_EQ(printable("plain\ttext\n"), "plain\ttext\n");
    EXPECT_EQ(printable("ä – € 😀"), "ä – € 😀");
    EXPECT_EQ(printable("\x1b[31m"), "?[31m");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "??31m"); // the same escape, as one character
    for (const char* illFormed : {"\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80",
                                  "\xf4\x90\x80\x80", "\xf0\x80\x80\x80", "\xe2\x82", "\x80"}) {
        const std::string text = illFormed;
        EXPECT_EQ(printable(text), std::string(text.size(), '?'));
    }
}

} // namespace
} // namespace tokay::channel
