// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChildProgram.hpp"
#include "ScriptedFluid.hpp"
#include "common/version.hpp"
#include "exampleCase.hpp"
#include "tableRows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

const std::string longRun = exampleText("end: 0.1", "end: 1e6");
const std::string coupledCase = exampleText() + "coupling: {interface: [left, top, right]}\n";

channel::Hello fluidHello() {
    channel::Hello hello;
    hello.role = channel::Role::fluid;
    hello.program = "scripted fluid";
    return hello;
}

// The program coupled over a socket pair, waiting for forces in its first step.
class CoupledProgram : public testing::Test {
  protected:
    CoupledProgram() {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
            throw std::runtime_error("no socket pair");
        }
        program.emplace(std::vector<std::string>{"run", directory.write("case.yaml", coupledCase),
                                                 "--channel-fd", "3"},
                        ends[1]);
        close(ends[1]);
        channel.emplace(channel::Channel::fromFileDescriptor(ends[0]));
        channel::shakeHands(*channel, fluidHello());
        channel->send(fluid);
        channel->receive<channel::Accepted>("accepted");
        channel->send(channel::BeginStep{1, 0.01, 0.01});
        channel->receive<channel::Displacements>("displacements");
    }

    std::string failureText() {
        try {
            channel->receive("a failure");
        } catch (const channel::PeerError& failure) {
            return failure.what();
        }
        return "no failure";
    }

    TemporaryDirectory directory;
    channel::Interface fluid = flapInterface(20);
    std::optional<ChildProgram> program;
    std::optional<channel::Channel> channel;
};

} // namespace

TEST(Program, version_is_that_of_the_project) {
    ChildProgram program({"--version"});
    EXPECT_EQ(program.wait(), 0);
    EXPECT_EQ(program.output(), std::string("igaStructure ") + version + "\n");
}

TEST(Program, missing_case_file_ends_with_one_message) {
    ChildProgram program({"run", "nowhere.yaml"});
    EXPECT_EQ(program.wait(), 1);
    EXPECT_EQ(program.output(), "\nigaStructure: error: cannot read case file 'nowhere.yaml': No "
                                "such file or directory\n");
}

TEST(Program, unknown_command_and_unknown_option_are_refused) {
    ChildProgram command({"walk", "case.yaml"});
    EXPECT_NE(command.wait(), 0);
    ChildProgram option({"run", "case.yaml", "--fast"});
    EXPECT_NE(option.wait(), 0);
    EXPECT_THAT(option.output(), HasSubstr("--fast"));
}

TEST(Program, check_prints_the_model_and_runs_nothing) {
    const TemporaryDirectory directory;
    ChildProgram program({"check", directory.write("case.yaml", exampleText())});
    EXPECT_EQ(program.wait(), 0);
    EXPECT_THAT(program.output(), HasSubstr("66 unknowns"));
    EXPECT_FALSE(std::filesystem::exists(directory.file("postProcessing")));
}

TEST(Program, check_warns_of_a_processor_that_openblas_does_not_know) {
    if (!__builtin_cpu_supports("avx2")) {
        GTEST_SKIP() << "Prescott's kernels are the right ones here";
    }
    const TemporaryDirectory directory;
    const std::string file = directory.write("case.yaml", exampleText());
    const auto outputWith = [&](const char* kernels) {
        setenv("OPENBLAS_CORETYPE", kernels, 1);
        ChildProgram program({"check", file});
        EXPECT_EQ(program.wait(), 0);
        unsetenv("OPENBLAS_CORETYPE");
        return program.output();
    };
    EXPECT_THAT(outputWith("Prescott"), HasSubstr("export OPENBLAS_CORETYPE=Haswell"));
    EXPECT_THAT(outputWith("Haswell"), Not(HasSubstr("OPENBLAS_CORETYPE")));
}

TEST(Program, run_alone_succeeds) {
    const TemporaryDirectory directory;
    ChildProgram program({"run", directory.write("case.yaml", exampleText())});
    EXPECT_EQ(program.wait(), 0);
    EXPECT_THAT(program.output(), HasSubstr("step 10 time 0.1 s"));
}

TEST(Program, signal_ends_a_run_alone_with_a_message) {
    for (int number : {SIGINT, SIGTERM}) {
        const TemporaryDirectory directory;
        ChildProgram program({"run", directory.write("case.yaml", longRun)});
        ASSERT_TRUE(program.waitForOutput("step 3 "));
        program.signal(number);
        EXPECT_EQ(program.wait(), 128 + number);
        EXPECT_THAT(program.output(), HasSubstr("interrupted by signal " + std::to_string(number)));
    }
}

TEST_F(CoupledProgram, signal_ends_it_and_the_fluid_hears_why) {
    program->signal(SIGINT);
    EXPECT_THAT(failureText(), HasSubstr("interrupted by signal 2"));
    EXPECT_EQ(program->wait(), 128 + SIGINT);
    EXPECT_THAT(program->output(), HasSubstr("interrupted by signal 2"));
}

TEST_F(CoupledProgram, fluid_that_is_killed_ends_it) {
    channel.reset(); // the system closes a dead process' sockets
    EXPECT_EQ(program->wait(5), 1);
    EXPECT_THAT(program->output(), HasSubstr("the fluid ended without saying why"));
}

TEST_F(CoupledProgram, killed_program_ends_the_fluids_wait) {
    program->signal(SIGKILL);
    EXPECT_THAT(failureText(), HasSubstr("the structure ended without saying why"));
    EXPECT_EQ(program->wait(), 1000 + SIGKILL);
}

TEST_F(CoupledProgram, goodbye_ends_it_in_good_order) {
    channel->send(channel::Forces{true, false, 0, forceOnLeft(fluid, 100)});
    EXPECT_EQ(channel->receive<channel::Displacements>("displacements").state,
              channel::State::accepted);
    channel->send(channel::Goodbye{"end time reached"});
    EXPECT_EQ(program->wait(), 0);
    EXPECT_THAT(program->output(), HasSubstr("the fluid ends the run: end time reached"));
}

TEST_F(CoupledProgram, tables_reach_a_time_before_the_fluid_is_told_to_write_it) {
    channel->send(channel::Forces{true, true, 0, forceOnLeft(fluid, 100)});
    channel->receive<channel::Displacements>("displacements");
    program->signal(SIGKILL);
    program->wait();
    for (const char* table : {"watchPoints.dat", "energy.dat", "iterations.dat"}) {
        const auto rows = tableRows(directory.read(std::string("postProcessing/case/0/") + table));
        ASSERT_EQ(rows.size(), 1u) << table;
        EXPECT_DOUBLE_EQ(rows.front().front(), 0.01) << table;
    }
}

TEST_F(CoupledProgram, results_that_cannot_be_written_end_both_sides) {
    std::filesystem::remove_all(directory.file("results"));
    directory.write("results", "a file where the directory should be");
    channel->send(channel::Forces{true, true, 0, forceOnLeft(fluid, 100)});
    EXPECT_THAT(failureText(), AllOf(HasSubstr("cannot write"), HasSubstr("results")));
    EXPECT_EQ(program->wait(), 1);
    EXPECT_THAT(program->output(), HasSubstr("cannot write"));
}

TEST(Program, listens_on_a_unix_socket_for_a_fluid) {
    const TemporaryDirectory directory;
    const std::string address = "unix:" + directory.file("socket");
    ChildProgram program({"run", directory.write("case.yaml", coupledCase), "--listen", address});
    ASSERT_TRUE(program.waitForOutput("waiting for a fluid at " + address));
    channel::Channel channel = channel::Channel::connect(address);
    channel::shakeHands(channel, fluidHello());
    channel.send(flapInterface(20));
    channel.receive<channel::Accepted>("accepted");
    channel.send(channel::Goodbye{"enough"});
    EXPECT_EQ(program.wait(), 0);
}

TEST(Program, signal_ends_the_wait_for_a_fluid) {
    const TemporaryDirectory directory;
    ChildProgram program({"run", directory.write("case.yaml", coupledCase), "--listen",
                          "unix:" + directory.file("socket")});
    ASSERT_TRUE(program.waitForOutput("waiting for a fluid"));
    program.signal(SIGTERM);
    EXPECT_EQ(program.wait(), 128 + SIGTERM);
}

TEST(Program, tcp_needs_a_token_and_a_wrong_one_does_not_end_the_wait) {
    const TemporaryDirectory directory;
    const std::string caseFile = directory.write("case.yaml", coupledCase);
    ChildProgram without({"run", caseFile, "--listen", "tcp://localhost:0"});
    EXPECT_EQ(without.wait(), 1);
    EXPECT_THAT(without.output(), HasSubstr("token"));

    const std::string tokenFile = directory.write("token", "secret\n");
    std::filesystem::permissions(tokenFile, std::filesystem::perms(0600));
    ChildProgram program(
        {"run", caseFile, "--listen", "tcp://localhost:0", "--token-file", tokenFile});
    ASSERT_TRUE(program.waitForOutput("waiting for a fluid at tcp://"));
    const std::string output = program.output();
    const auto start = output.find("tcp://");
    const std::string address = output.substr(start, output.find('\n', start) - start);
    channel::Channel stranger = channel::Channel::connect(address);
    EXPECT_THROW(channel::shakeHands(stranger, fluidHello(), "guess"), channel::PeerError);
    ASSERT_TRUE(program.waitForOutput("wrong token"));
    channel::Channel channel = channel::Channel::connect(address);
    channel::shakeHands(channel, fluidHello(), "secret");
    channel.send(flapInterface(20));
    channel.receive<channel::Accepted>("accepted");
    channel.send(channel::Goodbye{"enough"});
    EXPECT_EQ(program.wait(), 0);
}

TEST(Program, mistake_in_the_case_file_is_told_before_it_listens) {
    const TemporaryDirectory directory;
    ChildProgram program({"run", directory.write("case.yaml", "geometry: 3\n"), "--listen",
                          "unix:" + directory.file("socket")});
    EXPECT_EQ(program.wait(), 1);
    EXPECT_THAT(program.output(), HasSubstr("case.yaml:1:11: geometry: must be a map"));
}

TEST(Program, garbage_instead_of_a_fluid_ends_it) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    const TemporaryDirectory directory;
    ChildProgram program({"run", directory.write("case.yaml", coupledCase), "--channel-fd", "3"},
                         ends[1]);
    close(ends[1]);
    const std::string garbage(64, 'x');
    ASSERT_EQ(write(ends[0], garbage.data(), garbage.size()), 64);
    EXPECT_EQ(program.wait(), 1);
    EXPECT_THAT(program.output(), HasSubstr("igaStructure: error: "));
    close(ends[0]);
}

TEST(Program, file_descriptor_that_is_no_socket_is_refused) {
    const TemporaryDirectory directory;
    ChildProgram program({"run", directory.write("case.yaml", coupledCase), "--channel-fd", "1"});
    EXPECT_EQ(program.wait(), 1);
    EXPECT_THAT(program.output(), HasSubstr("File descriptor 1 is no connected stream socket"));
}
