// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/Listener.hpp"
#include "common/errors.hpp"
#include "connectedPair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace tokay::channel {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class ListenerTest : public ::testing::Test {
  protected:
    ListenerTest() {
        std::string name = (std::filesystem::temp_directory_path() / "tokayXXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~ListenerTest() override { std::filesystem::remove_all(folder_); }

    std::string socketFile() const { return (folder_ / "socket").string(); }
    std::string unixAddress() const { return "unix:" + socketFile(); }

    std::filesystem::path folder_;
};

void expectConversation(Listener& listener) {
    std::thread fluid([address = listener.address()] {
        Channel channel = Channel::connect(address);
        channel.send(BeginStep{3, 0.3, 0.1});
        EXPECT_EQ(channel.receive<Goodbye>("an answer").reason, "enough");
    });
    Channel channel = listener.accept();
    EXPECT_EQ(channel.receive<BeginStep>("a step").step, 3u);
    channel.send(Goodbye{"enough"});
    fluid.join();
}

TEST_F(ListenerTest, unixSocketConnectsFluidAndStructure) {
    Listener listener(unixAddress());
    EXPECT_EQ(listener.address(), unixAddress());
    expectConversation(listener);
}

TEST_F(ListenerTest, tcpConnectsFluidAndStructureOnAFreePort) {
    Listener listener("tcp://localhost:0", "secret");
    EXPECT_THAT(listener.address(), StartsWith("tcp://"));
    expectConversation(listener);
}

TEST_F(ListenerTest, tcpWithoutAHostListensOnLoopbackOnly) {
    const Listener listener("tcp://:0", "secret");
    EXPECT_THAT(listener.address(), StartsWith("tcp://127.0.0.1:"));
}

TEST_F(ListenerTest, tcpWithoutATokenIsRefused) {
    EXPECT_THAT(errorOf<InputError>([] { Listener("tcp://localhost:0"); }),
                HasSubstr("needs a token"));
}

TEST_F(ListenerTest, unixSocketIsForThisUserOnlyAndGoesWithTheListener) {
    {
        const Listener listener(unixAddress());
        struct stat status;
        ASSERT_EQ(stat(socketFile().c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, 0600u);
    }
    EXPECT_FALSE(std::filesystem::exists(socketFile()));
}

TEST_F(ListenerTest, socketLeftByAKilledStructureIsReplaced) {
    { // a bound socket that nobody listens to
        const int abandoned = socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        socketFile().copy(address.sun_path, sizeof address.sun_path - 1);
        ASSERT_EQ(bind(abandoned, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        close(abandoned);
    }
    Listener listener(unixAddress());
    expectConversation(listener);
}

TEST_F(ListenerTest, socketInUseIsNotTakenAway) {
    Listener first(unixAddress());
    EXPECT_THAT(errorOf<InputError>([&] { Listener second(unixAddress()); }),
                HasSubstr("Cannot listen at"));
    expectConversation(first); // the attempt has not disturbed it
}

TEST_F(ListenerTest, fileOfTheUserIsNeverReplaced) {
    std::ofstream(socketFile()) << "precious";
    EXPECT_THROW(Listener{unixAddress()}, InputError);
    std::string text;
    std::ifstream(socketFile()) >> text;
    EXPECT_EQ(text, "precious");
}

TEST_F(ListenerTest, reportsThatNobodyAttaches) {
    Listener listener(unixAddress());
    int nReports = 0;
    listener.reportSilence(0.02, [&](const std::string& line) {
        EXPECT_THAT(line, HasSubstr("waiting for a fluid to attach at unix:"));
        if (++nReports == 2) {
            throw SolverError("interrupted");
        }
    });
    EXPECT_THROW(listener.accept(), SolverError);
}

TEST_F(ListenerTest, connectingToNobodySaysWhatToDo) {
    EXPECT_THAT(errorOf<PeerError>([this] { Channel::connect(unixAddress()); }),
                HasSubstr("start the structure first"));
}

TEST(Address, malformedOnesAreRefusedNamingTheFormsAllowed) {
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
