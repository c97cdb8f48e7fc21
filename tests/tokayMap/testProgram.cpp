// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporaryDirectory.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <cstring>

namespace tokay::tool {

namespace {

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

class Program : public testing::Test {
  protected:
    Program() {
        directory.write("a.obj", square);
        directory.write("b.obj", square);
    }

    /// @return exit status
    int run(const std::string& arguments) {
        const std::string command =
            "cd " + directory.file("") + " && " TOKAY_MAP " " + arguments + " > output 2>&1";
        const int status = std::system(command.c_str());
        output = directory.read("output");
        return WEXITSTATUS(status);
    }

    TemporaryDirectory directory;
    std::string output;
};

} // namespace

TEST_F(Program, maps_in_one_line_and_prints_the_report) {
    EXPECT_EQ(run("a.obj b.obj --test-function 1+x+2*y --operator mortar --basis dual -o c.vtu"), 0)
        << output;
    EXPECT_NE(output.find("mapping: mortar, dual basis"), std::string::npos) << output;
    EXPECT_NE(output.find("error against 1+x+2*y"), std::string::npos) << output;
    EXPECT_EQ(run("--list c.vtu"), 0);
    EXPECT_NE(output.find("values"), std::string::npos) << output;
    EXPECT_NE(output.find("1 to 4"), std::string::npos) << output;
}

TEST_F(Program, ends_with_a_message_when_the_input_is_wrong) {
    EXPECT_EQ(run("a.obj missing.vtu --test-function x"), 1);
    EXPECT_NE(output.find("tokay-map: error: missing.vtu"), std::string::npos) << output;
    EXPECT_NE(run("a.obj b.obj --test-function x --operator nearest"), 0);
    EXPECT_NE(output.find("nearestElement"), std::string::npos) << output;
    EXPECT_NE(run("a.obj b.obj --test-function x --field p"), 0);
    EXPECT_NE(run("a.obj --test-function x"), 0);
    EXPECT_NE(output.find("TO"), std::string::npos) << output;
    EXPECT_EQ(run("a.obj b.obj --test-function x --operator rbf --kernel gauss"), 1);
    EXPECT_NE(output.find("compactC2"), std::string::npos) << output;
    for (const char* const option :
         {"--scale-from nan", "--gap-limit inf", "--divisions 1000000000", "--degree 1000"}) {
        EXPECT_NE(run(std::string("a.obj b.obj --test-function x ") + option), 0) << option;
        EXPECT_NE(output.find(std::strchr(option, ' ') + 1), std::string::npos) << output;
    }
}

} // namespace tokay::tool
