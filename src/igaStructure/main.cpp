// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/Listener.hpp"
#include "channel/handshake/readToken.hpp"
#include "common/errors.hpp"
#include "common/version.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/coupledRun/CoupledRun.hpp"
#include "igaStructure/edgeCoupling/runCouple.hpp"
#include "igaStructure/run/Interruption.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"
#include "igaStructure/run/runModes.hpp"

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <new>

namespace {

using namespace tokay;

// Line by line on the way, so that the log can be watched.
void print(const std::string& text) {
    const bool endsLine = !text.empty() && text.back() == '\n';
    fmt::print(endsLine ? "{}" : "{}\n", text);
    std::fflush(stdout);
}

struct RunOptions {
    std::string caseFile;
    int fileDescriptor = -1;
    std::string address;
    std::string tokenFile;
    structure::CoupledRunOptions coupled;
};

channel::Channel waitForFluid(const RunOptions& options, const std::string& token) {
    channel::Listener listener(options.address, token);
    listener.reportSilence(0.2, [](const std::string&) { structure::throwIfInterrupted(); });
    listener.reportRefusals(print);
    print("waiting for a fluid at " + listener.address());
    return listener.accept(structure::structureGreeting());
}

void run(const RunOptions& options) {
    const std::string token =
        options.tokenFile.empty() ? std::string() : channel::readToken(options.tokenFile);
    if (options.fileDescriptor < 0 && options.address.empty()) {
        structure::runAlone(structure::readCase(options.caseFile), print);
        return;
    }
    std::signal(SIGPIPE, SIG_IGN); // a closed log must not end a coupled run
    if (!options.address.empty()) {
        structure::readLoadedCase(options.caseFile); // a mistake is told before a fluid attaches
    }
    // A launching fluid must hear of a mistake in the case file: attach first, then read.
    channel::Channel channel = options.fileDescriptor >= 0
                                   ? channel::Channel::fromFileDescriptor(options.fileDescriptor)
                                   : waitForFluid(options, token);
    structure::runCoupled(options.caseFile, std::move(channel), options.coupled, print);
}

void addRun(CLI::App& app) {
    CLI::App* command = app.add_subcommand("run", "Run a case, alone or coupled to a fluid");
    auto options = std::make_shared<RunOptions>();
    command->add_option("CASE.yaml", options->caseFile, "Case file")->required();
    auto* descriptor = command->add_option("--channel-fd", options->fileDescriptor,
                                           "Coupled, over this connected socket (set by a fluid "
                                           "that launches this program)");
    auto* listen =
        command->add_option("--listen", options->address,
                            "Coupled to a fluid that connects here: unix:/path or tcp://host:port");
    listen->excludes(descriptor);
    command
        ->add_option("--token-file", options->tokenFile,
                     "File with the secret shared with the fluid; needed with tcp")
        ->needs(listen);
    command->add_option("--record", options->coupled.recordFile,
                        "Coupled: write accepted interface displacements to this file");
    command->add_option("--replay", options->coupled.replayFile,
                        "Coupled: answer the displacements of this file, solve no structure");
    command->add_option("--silence-interval", options->coupled.silenceInterval,
                        "Coupled: seconds after which a silent fluid is reported (60)");
    command->callback([options] { run(*options); });
}

void addCouple(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("couple", "Run two structures that are coupled along edges");
    auto options = std::make_shared<structure::CoupleOptions>();
    command
        ->add_option("CASE.yaml", options->caseFiles,
                     "Case files of the two; the one with coupling.side dirichlet is moved by the "
                     "other, and loads it")
        ->required()
        ->expected(2);
    auto* connect = command->add_option(
        "--connect", options->address,
        "The other one runs already (igaStructure run --listen): unix:/path or tcp://host:port");
    command
        ->add_option("--token-file", options->tokenFile,
                     "File with the secret shared with it; needed with tcp")
        ->needs(connect);
    command->add_option("--restart", options->restartTime,
                        "Go on from the states that both have saved at this time [s]");
    command->add_flag("--mass-matrix", options->printsMassMatrix,
                      "Print the matrix M_DD of the moved edges");
    command->callback([options] {
        std::signal(SIGPIPE, SIG_IGN); // a closed log must not end the other structure
        structure::runCouple(*options, print);
    });
}

void addCheck(CLI::App& app) {
    CLI::App* check =
        app.add_subcommand("check", "Check a case file and say what would be modelled");
    auto caseFile = std::make_shared<std::string>();
    check->add_option("CASE.yaml", *caseFile, "Case file")->required();
    check->callback([=] { print(structure::checkCase(structure::readCase(*caseFile))); });
}

void addModes(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("modes", "Natural frequencies and modes of a case, undamped, at rest");
    auto caseFile = std::make_shared<std::string>();
    auto count = std::make_shared<int>(6);
    command->add_option("CASE.yaml", *caseFile, "Case file")->required();
    command->add_option("--count", *count, "How many, the lowest ones (6)")
        ->check(CLI::PositiveNumber);
    command->callback([=] { structure::runModes(structure::readCase(*caseFile), *count, print); });
}

void addEntries(CLI::App& app) {
    CLI::App* entries =
        app.add_subcommand("entries", "Print all entries of a case file (Markdown)");
    entries->callback([] { print(structure::describeCaseEntries()); });
}

int runProgram(int argc, char** argv) {
    CLI::App app("Isogeometric structures, alone or coupled to OpenFOAM", "igaStructure");
    app.set_version_flag("--version", std::string("igaStructure ") + version);
    app.require_subcommand(1);
    addRun(app);
    addCouple(app);
    addCheck(app);
    addModes(app);
    addEntries(app);
    CLI11_PARSE(app, argc, argv);
    return 0;
}

int fail(const std::string& message) {
    std::fflush(stdout);
    fmt::print(stderr, "\nigaStructure: error: {}\n", message);
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    // The cores are shared out by elements. Eigen's own threads would wait for each
    // other by spinning, and take the cores from a fluid; and sums would depend on
    // their number.
    Eigen::setNbThreads(1);
    structure::rememberSignals();
    try {
        return runProgram(argc, argv);
    } catch (const structure::Interrupted& interrupted) {
        fail(interrupted.what());
        return 128 + interrupted.signal();
    } catch (const std::bad_alloc&) {
        return fail("out of memory; use fewer elements or a lower degree");
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}
