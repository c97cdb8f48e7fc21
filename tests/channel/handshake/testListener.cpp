// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/connectedPair.hpp"
#include "channel/handshake/Listener.hpp"
#include "channel/handshake/readToken.hpp"
#include "channel/handshake/shakeHands.hpp"
#include "common/errors.hpp"
#include "temporaryDirectory.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace tokay::channel {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ListenerTest : public ::testing::Test {
  protected:
    std::string socketFile() const { return directory_.file("socket"); }
    std::string unixAddress() const { return "unix:" + socketFile(); }

    TemporaryDirectory directory_;
};

const std::string token = "secret";

Hello greeting(Role role) {
    Hello hello;
    hello.role = role;
    hello.program = role == Role::fluid ? "pimpleFoam" : "igaStructure";
    return hello;
}

void expectConversation(Listener& listener) {
    std::thread fluid([address = listener.address()] {
        Channel channel = Channel::connect(address);
        shakeHands(channel, greeting(Role::fluid), token);
        channel.send(BeginStep{3, 0.3, 0.1});
        EXPECT_EQ(channel.receive<Goodbye>("an answer").reason, "enough");
    });
    Channel channel = listener.accept(greeting(Role::structure));
    EXPECT_TRUE(channel.isTrusted());
    EXPECT_EQ(channel.peer(), "the fluid");
    EXPECT_EQ(channel.receive<BeginStep>("a step").step, 3u);
    channel.send(Goodbye{"enough"});
    fluid.join();
}

TEST_F(ListenerTest, unix_socket_connects_fluid_and_structure) {
    Listener listener(unixAddress(), token);
    EXPECT_EQ(listener.address(), unixAddress());
    expectConversation(listener);
}

TEST_F(ListenerTest, tcp_connects_fluid_and_structure_on_a_free_port) {
    Listener listener("tcp://localhost:0", token);
    EXPECT_THAT(listener.address(), StartsWith("tcp://"));
    expectConversation(listener);
}

TEST_F(ListenerTest, tcp_without_a_host_listens_on_loopback_only) {
    const Listener listener("tcp://:0", token);
    EXPECT_THAT(listener.address(), StartsWith("tcp://127.0.0.1:"));
}

TEST_F(ListenerTest, tcp_without_a_token_is_refused) {
    EXPECT_THAT(errorOf<InputError>([] { Listener("tcp://localhost:0"); }),
                HasSubstr("needs a token"));
}

TEST_F(ListenerTest, unix_socket_is_for_this_user_only_and_goes_with_the_listener) {
    {
        const Listener listener(unixAddress(), token);
        struct stat status;
        ASSERT_EQ(stat(socketFile().c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, 0600u);
    }
    EXPECT_FALSE(std::filesystem::exists(socketFile()));
}

TEST_F(ListenerTest, socket_left_by_a_killed_structure_is_replaced) {
    { // a bound socket that nobody listens to
        const int abandoned = socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        socketFile().copy(address.sun_path, sizeof address.sun_path - 1);
        ASSERT_EQ(bind(abandoned, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        close(abandoned);
    }
    Listener listener(unixAddress(), token);
    expectConversation(listener);
}

TEST_F(ListenerTest, socket_in_use_is_not_taken_away) {
    Listener first(unixAddress(), token);
    EXPECT_THAT(errorOf<InputError>([&] { Listener second(unixAddress()); }),
                HasSubstr("Cannot listen at"));
    expectConversation(first); // the attempt has not disturbed it
}

TEST_F(ListenerTest, file_of_the_user_is_never_replaced) {
    std::ofstream(socketFile()) << "precious";
    EXPECT_THROW(Listener{unixAddress()}, InputError);
    std::string text;
    std::ifstream(socketFile()) >> text;
    EXPECT_EQ(text, "precious");
}

TEST_F(ListenerTest, reports_that_nobody_attaches) {
    Listener listener(unixAddress(), token);
    int nReports = 0;
    listener.reportSilence(0.02, [&](const std::string& line) {
        EXPECT_THAT(line, HasSubstr("waiting for a fluid to attach at unix:"));
        if (++nReports == 2) {
            throw SolverError("interrupted");
        }
    });
    EXPECT_THROW(listener.accept(greeting(Role::structure)), SolverError);
}

TEST_F(ListenerTest, connecting_to_nobody_says_what_to_do) {
    EXPECT_THAT(errorOf<PeerError>([this] { Channel::connect(unixAddress()); }),
                HasSubstr("start the structure first"));
}

/// A listener in a thread of its own, which waits for the fluid all the time, and
/// what it says of those that it refuses.
class Strangers : public ListenerTest {
  protected:
    explicit Strangers(const Listener::Patience& patience = {})
        : listener("tcp://:0", token, patience), address(listener.address()) {
        listener.reportRefusals([this](const std::string& line) {
            const std::lock_guard<std::mutex> lock(mutex);
            refusals.push_back(line);
        });
        listener.reportSilence(0.05, [this](const std::string&) {
            if (ends) {
                throw SolverError("the test ends");
            }
        });
        accepted = std::async(std::launch::async,
                              [this] { return listener.accept(greeting(Role::structure)); });
    }

    ~Strangers() override { ends = true; }

    /// Connects without a handshake.
    int connectRaw() const {
        const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in where{};
        where.sin_family = AF_INET;
        where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        where.sin_port =
            htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
        EXPECT_EQ(connect(descriptor, reinterpret_cast<sockaddr*>(&where), sizeof where), 0);
        return descriptor;
    }

    std::vector<std::string> waitForRefusals(std::size_t count) {
        for (int i = 0; i < 1000; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            const std::lock_guard<std::mutex> lock(mutex);
            if (refusals.size() >= count) {
                return refusals;
            }
        }
        ADD_FAILURE() << "no " << count << " refusals";
        return {};
    }

    /// The rightful fluid comes through, at once.
    void expectFluidIsAccepted() {
        const auto start = std::chrono::steady_clock::now();
        Channel fluid = Channel::connect(address);
        shakeHands(fluid, greeting(Role::fluid), token);
        Channel structure = accepted.get();
        structure.send(Goodbye{"enough"});
        EXPECT_EQ(fluid.receive<Goodbye>("an answer").reason, "enough");
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    }

    Listener listener;
    std::string address;
    std::atomic<bool> ends{false};
    std::mutex mutex;
    std::vector<std::string> refusals;
    std::future<Channel> accepted;
};

TEST_F(Strangers, who_connects_and_closes_does_not_end_the_wait) {
    close(connectRaw());
    EXPECT_THAT(waitForRefusals(1).at(0),
                AllOf(StartsWith("refused 127.0.0.1:"), HasSubstr("it ended the connection")));
    expectFluidIsAccepted();
}

TEST_F(Strangers, who_speaks_http_does_not_end_the_wait) {
    const int stranger = connectRaw();
    const std::string request = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
    EXPECT_EQ(write(stranger, request.data(), request.size()),
              static_cast<ssize_t>(request.size()));
    EXPECT_THAT(waitForRefusals(1).at(0), HasSubstr("not a message of Tokay"));
    expectFluidIsAccepted();
    close(stranger);
}

TEST_F(Strangers, who_has_a_wrong_token_is_told_and_does_not_end_the_wait) {
    Channel stranger = Channel::connect(address);
    EXPECT_THAT(errorOf<PeerFailure>([&] { shakeHands(stranger, greeting(Role::fluid), "guess"); }),
                HasSubstr("the fluid gave a wrong token: give both sides the same secret"));
    EXPECT_THAT(waitForRefusals(1).at(0), HasSubstr("the fluid gave a wrong token"));
    expectFluidIsAccepted();
}

TEST_F(Strangers, who_speaks_another_version_is_told_both) {
    Channel stranger = Channel::connect(address);
    Hello newer = greeting(Role::fluid);
    newer.protocol = 42;
    EXPECT_THAT(errorOf<PeerFailure>([&] { shakeHands(stranger, newer, token); }),
                HasSubstr("version 42"));
    expectFluidIsAccepted();
}

TEST_F(Strangers, cannot_write_into_the_log) {
    Channel stranger = Channel::connect(address);
    stranger.send(Failure{"\x1b[2J\nstep 1 time 0.1 s" + std::string(1000, 'x')});
    const std::string line = waitForRefusals(1).at(0);
    EXPECT_THAT(line, AllOf(HasSubstr("?[2J step 1"), Not(HasSubstr("\n"))));
    EXPECT_LT(line.size(), 200u);
    expectFluidIsAccepted();
}

TEST_F(Strangers, a_hundred_silent_ones_do_not_hold_up_the_fluid) {
    std::vector<int> strangers;
    for (int i = 0; i < 100; ++i) {
        strangers.push_back(connectRaw());
    }
    expectFluidIsAccepted();
    for (const int stranger : strangers) {
        close(stranger);
    }
}

TEST_F(Strangers, a_hundred_that_come_and_go_are_reported_once_in_a_while) {
    for (int i = 0; i < 100; ++i) {
        close(connectRaw());
    }
    EXPECT_EQ(waitForRefusals(21).at(20), "further refusals are not reported");
    expectFluidIsAccepted();
    EXPECT_EQ(refusals.size(), 21u);
}

class ImpatientListener : public Strangers {
  protected:
    ImpatientListener() : Strangers({0.2, 3}) {}
};

TEST_F(ImpatientListener, dismisses_who_is_silent_for_too_long) {
    const int stranger = connectRaw();
    EXPECT_THAT(waitForRefusals(1).at(0), HasSubstr("no handshake within 0.2 s"));
    char byte;
    EXPECT_EQ(read(stranger, &byte, 1), 0); // the connection is closed
    expectFluidIsAccepted();
    close(stranger);
}

class CrowdedListener : public Strangers {
  protected:
    CrowdedListener() : Strangers({10, 3}) {}
};

TEST_F(CrowdedListener, dismisses_the_oldest_when_there_are_too_many) {
    std::vector<int> strangers;
    for (int i = 0; i < 4; ++i) {
        strangers.push_back(connectRaw());
    }
    EXPECT_THAT(waitForRefusals(1).at(0), HasSubstr("too many others came"));
    expectFluidIsAccepted();
    for (const int stranger : strangers) {
        close(stranger);
    }
}

TEST(Token, is_the_first_line_of_a_file_for_its_owner_alone) {
    const TemporaryDirectory directory;
    const std::string name = directory.write("token", "  open sesame \r\nmore\n");
    chmod(name.c_str(), 0600);
    EXPECT_EQ(readToken(name), "open sesame");
    for (const mode_t mode : {0640, 0604, 0620, 0601, 0666}) {
        chmod(name.c_str(), mode);
        EXPECT_THAT(errorOf<InputError>([&] { readToken(name); }),
                    AllOf(HasSubstr("is open to other users"), HasSubstr("chmod 600 " + name)));
    }
    std::filesystem::remove(name);
    EXPECT_THAT(errorOf<InputError>([&] { readToken(name); }), HasSubstr("cannot be read"));
}

TEST(Address, malformed_ones_are_refused_naming_the_forms_allowed) {
    for (const char* text : {"", "localhost:5000", "http://localhost:5000", "tcp://localhost",
                             "tcp://localhost:", "tcp://localhost:70000", "tcp://localhost:-1",
                             "tcp://::1:5000", "unix:"}) {
        EXPECT_THAT(errorOf<InputError>([text] { Channel::connect(text); }),
                    HasSubstr("\"tcp://host:port\""))
            << text;
    }
    EXPECT_THAT(errorOf<InputError>([] { Channel::connect("unix:/" + std::string(200, 'a')); }),
                HasSubstr("201 characters"));
}

} // namespace
} // namespace tokay::channel
