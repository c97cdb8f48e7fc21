// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/allFinite.hpp"
#include "channel/encoding.hpp"
#include "common/errors.hpp"
#include "connectedPair.hpp"
#include "exampleMessages.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <future>
#include <random>
#include <thread>

namespace tokay::channel {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void writeRaw(int fileDescriptor, const Bytes& bytes) {
    ASSERT_EQ(write(fileDescriptor, bytes.data(), bytes.size()),
              static_cast<ssize_t>(bytes.size()));
}

TEST(Channel, carries_every_type_of_message_in_order) {
    auto [fluid, structure] = connectedPair();
    for (const Message& message : exampleMessages()) {
        if (!std::holds_alternative<Failure>(message)) {
            fluid.send(message);
        }
    }
    for (const Message& message : exampleMessages()) {
        if (!std::holds_alternative<Failure>(message)) {
            EXPECT_EQ(encodeFrame(structure.receive("a message")), encodeFrame(message));
        }
    }
}

TEST(Channel, carries_messages_larger_than_any_socket_buffer_both_ways) {
    auto [fluid, structure] = connectedPair();
    fluid.trust("the structure");
    structure.trust("the fluid");
    std::vector<double> values(1000000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 1.0 / (1.0 + static_cast<double>(i));
    }
    std::thread peer([&structure = structure] {
        const Forces forces = structure.receive<Forces>("the fluid's forces");
        structure.send(Displacements{State::iterate, 0.5, forces.values, ""});
    });
    fluid.send(Forces{false, false, 0, values});
    EXPECT_EQ(fluid.receive<Displacements>("the structure's answer").values, values);
    peer.join();
}

TEST(Channel, reports_that_the_peer_ended_without_a_word) {
    auto [fluid, structure] = connectedPair();
    fluid.trust("the structure");
    { const Channel ended = std::move(structure); }
    EXPECT_THAT(errorOf<PeerError>([&] { fluid.receive("the displacements, step 3"); }),
                AllOf(HasSubstr("the structure ended without saying why"),
                      HasSubstr("the displacements, step 3")));
}

TEST(Channel, notices_a_killed_peer_at_once) {
    const auto [own, childs] = socketPair();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        raise(SIGKILL);
    }
    close(childs);
    Channel channel = Channel::fromFileDescriptor(own);
    const Stopwatch watch;
    EXPECT_THROW(channel.receive("a message"), PeerError);
    EXPECT_LT(watch.seconds(), 2); // at once, on a busy machine
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
}

TEST(Channel, sending_to_an_ended_peer_is_an_error_and_not_a_signal) {
    std::signal(SIGPIPE, SIG_DFL);
    auto [fluid, structure] = connectedPair();
    { const Channel ended = std::move(structure); }
    EXPECT_THAT(errorOf<PeerError>([&] { fluid.send(Goodbye{"end"}); }),
                HasSubstr("ended without saying why"));
    EXPECT_FALSE(fluid.trySend(Failure{"too late"}));
}

TEST(Channel, sending_to_a_peer_that_failed_tells_its_reason) {
    auto [fluid, structure] = connectedPair();
    fluid.trust("the structure");
    {
        Channel ending = std::move(structure);
        ending.send(Failure{"Newton diverged in step 5"});
    }
    EXPECT_THAT(errorOf<PeerFailure>([&] { fluid.send(Goodbye{"end"}); }),
                HasSubstr("the structure ended: Newton diverged in step 5"));
}

TEST(Channel, received_failure_carries_the_peers_text_and_an_own_type) {
    auto [fluid, structure] = connectedPair();
    fluid.trust("the structure");
    structure.send(Failure{"Newton diverged in step 5"});
    EXPECT_THAT(errorOf<PeerFailure>([&] { fluid.receive<Displacements>("the answer"); }),
                HasSubstr("the structure ended: Newton diverged in step 5"));
}

TEST(Channel, names_a_message_that_was_not_expected) {
    auto [fluid, structure] = connectedPair();
    structure.send(BeginStep{1, 0.1, 0.1});
    EXPECT_THAT(errorOf<PeerError>([&] { fluid.receive<Displacements>("the answer, step 1"); }),
                AllOf(HasSubstr("BeginStep"), HasSubstr("the answer, step 1")));
    structure.send(Goodbye{"end time reached"});
    EXPECT_THAT(errorOf<PeerError>([&] { fluid.receive<Displacements>("the answer, step 1"); }),
                AllOf(HasSubstr("goodbye"), HasSubstr("end time reached")));
}

TEST(Channel, reports_a_silent_peer_each_interval_and_goes_on_waiting) {
    auto [fluid, structure] = connectedPair();
    std::vector<std::string> reports;
    std::promise<void> reportedTwice;
    structure.reportSilence(0.05, [&](const std::string& line) {
        reports.push_back(line);
        if (reports.size() == 2) {
            reportedTwice.set_value();
        }
    });
    std::thread peer([&fluid = fluid, reported = reportedTwice.get_future()] {
        reported.wait_for(std::chrono::seconds(60));
        fluid.send(Forces{});
    });
    const Stopwatch watch;
    structure.receive<Forces>("the fluid's forces, step 12");
    const double waited = watch.seconds();
    peer.join();
    ASSERT_GE(reports.size(), 2u);
    EXPECT_LE(static_cast<double>(reports.size()), waited / 0.05 + 1); // one by rounding
    EXPECT_EQ(reports.front(), "waiting for the fluid's forces since 0 s, step 12");
}

TEST(Channel, reports_a_peer_that_stops_in_the_middle_of_a_message) {
    const auto [own, raw] = socketPair();
    Channel channel = Channel::fromFileDescriptor(own);
    int nReports = 0;
    channel.reportSilence(0.05, [&](const std::string&) {
        if (++nReports == 2) {
            close(raw);
        }
    });
    Bytes half = encodeFrame(Goodbye{"end time reached"});
    half.resize(half.size() - 3);
    writeRaw(raw, half);
    EXPECT_THROW(channel.receive("a message"), PeerError);
    EXPECT_EQ(nReports, 2);
}

TEST(Channel, an_exception_of_the_report_ends_the_wait) {
    auto [fluid, structure] = connectedPair();
    structure.reportSilence(0.02, [](const std::string&) { throw SolverError("interrupted"); });
    EXPECT_THROW(structure.receive("the fluid's forces"), SolverError);
    EXPECT_THROW(fluid.receive("the answer"), PeerError); // the channel is closed
}

TEST(Channel, telltale_on_the_way_out_gives_up_on_a_peer_that_does_not_read) {
    auto [fluid, structure] = connectedPair();
    const Stopwatch watch;
    EXPECT_FALSE(fluid.trySend(Forces{false, false, 0, std::vector<double>(1000000)}));
    EXPECT_LT(watch.seconds(), 5); // two seconds, on a busy machine
}

TEST(Channel, refuses_garbage) {
    const auto [own, raw] = socketPair();
    Channel channel = Channel::fromFileDescriptor(own);
    writeRaw(raw, Bytes(64, 0x5a));
    EXPECT_THAT(errorOf<PeerError>([&] { channel.receive("a message"); }),
                HasSubstr("not a message of Tokay"));
    close(raw);
}

TEST(Channel, mutilated_frames_end_in_an_error_and_never_hang) {
    std::mt19937 random(5);
    const std::vector<Message> messages = exampleMessages();
    for (int i = 0; i < 1000; ++i) {
        const auto [own, raw] = socketPair();
        Channel channel = Channel::fromFileDescriptor(own);
        Bytes frame = encodeFrame(messages[random() % messages.size()]);
        for (int flips = 0; flips < 3; ++flips) {
            frame[random() % frame.size()] ^= static_cast<std::uint8_t>(1u << (random() % 8));
        }
        frame.resize(frame.size() - random() % 4);
        writeRaw(raw, frame);
        close(raw);
        EXPECT_THROW(
            {
                channel.receive("a message"); // if it was still one, the stream's end follows
                channel.receive("a message");
            },
            PeerError);
    }
}

TEST(Channel, refuses_large_messages_before_the_handshake) {
    auto [fluid, structure] = connectedPair();
    std::thread sender([&fluid = fluid] {
        fluid.trySend(Forces{false, false, 0, std::vector<double>(10000)});
    });
    EXPECT_THAT(errorOf<PeerError>([&] { structure.receive("a greeting"); }),
                HasSubstr("more than the limit of 65536"));
    { const Channel ended = std::move(structure); }
    sender.join();
}

TEST(Channel, an_announced_but_missing_gigabyte_is_not_allocated) {
    const auto [own, raw] = socketPair();
    Channel channel = Channel::fromFileDescriptor(own);
    channel.trust("the fluid");
    Bytes frame = encodeFrame(Forces{});
    frame[15] = 0x3f; // payload length 0x3f...... bytes
    writeRaw(raw, frame);
    close(raw);
    rusage before;
    getrusage(RUSAGE_SELF, &before);
    EXPECT_THROW(channel.receive("the fluid's forces"), PeerError);
    rusage after;
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 * 1024); // [kB]; the first portion is 1 MB
}

TEST(Channel, is_not_inherited_by_programs_started_later) {
    const auto [own, other] = socketPair();
    const Channel channel = Channel::fromFileDescriptor(own);
    EXPECT_TRUE(fcntl(own, F_GETFD) & FD_CLOEXEC);
    close(other);
}

TEST(Channel, refuses_a_file_descriptor_that_is_no_connected_socket) {
    int pipeEnds[2];
    ASSERT_EQ(pipe(pipeEnds), 0);
    EXPECT_THROW(Channel::fromFileDescriptor(pipeEnds[0]), InputError);
    EXPECT_THROW(Channel::fromFileDescriptor(-1), InputError);
    close(pipeEnds[0]);
    close(pipeEnds[1]);
}

TEST(Finite, finds_the_first_value_that_is_not) {
    EXPECT_TRUE(allFinite({0, -1, 1e300}));
    EXPECT_FALSE(allFinite({0, std::nan("")}));
    EXPECT_EQ(firstNonFinite({0, 1, 1 / std::numeric_limits<double>::min() * 1e10, std::nan("")}),
              std::size_t{2});
}

} // namespace
} // namespace tokay::channel
