#include "common/errors.hpp"
#include "common/version.hpp"
#include "igaStructure/caseFile/CaseEntry.hpp"
#include "igaStructure/caseFile/readCase.hpp"
#include "igaStructure/run/Interruption.hpp"
#include "igaStructure/run/checkCase.hpp"
#include "igaStructure/run/runAlone.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace {

using namespace tokay;

// Line by line on the way, so that the log can be watched.
void print(const std::string& text) {
    const bool endsLine = !text.empty() && text.back() == '\n';
    fmt::print(endsLine ? "{}" : "{}\n", text);
    std::fflush(stdout);
}

void addRun(CLI::App& app) {
    CLI::App* run = app.add_subcommand("run", "Run a case, alone or coupled to a fluid");
    auto caseFile = std::make_shared<std::string>();
    run->add_option("CASE.yaml", *caseFile, "Case file")->required();
    run->callback([=] { structure::runAlone(structure::readCase(*caseFile), print); });
}

void addCheck(CLI::App& app) {
    CLI::App* check =
        app.add_subcommand("check", "Check a case file and say what would be modelled");
    auto caseFile = std::make_shared<std::string>();
    check->add_option("CASE.yaml", *caseFile, "Case file")->required();
    check->callback([=] { print(structure::checkCase(structure::readCase(*caseFile))); });
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
    addCheck(app);
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
