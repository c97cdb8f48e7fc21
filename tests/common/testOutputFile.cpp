// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/OutputFile.hpp"
#include "fileSizeLimit.hpp"
#include "temporaryDirectory.hpp"

#include <gtest/gtest.h>

namespace tokay {

TEST(OutputFile, appears_under_its_name_when_it_is_published) {
    const TemporaryDirectory directory;
    {
        OutputFile file(directory.file("a/b/result.dat"));
        file.write("one");
        EXPECT_FALSE(std::filesystem::exists(directory.file("a/b/result.dat")));
        file.publish();
        EXPECT_EQ(directory.read("a/b/result.dat"), "one");
        file.write(" two");
        file.flush();
    }
    EXPECT_EQ(directory.read("a/b/result.dat"), "one two");
    EXPECT_FALSE(std::filesystem::exists(directory.file("a/b/result.dat.part")));
}

TEST(OutputFile, full_disk_is_reported_and_the_older_file_stays) {
    const TemporaryDirectory directory;
    directory.write("result.dat", "older result");
    const FileSizeLimit limit(1000);
    const auto writeMuch = [&] {
        OutputFile file(directory.file("result.dat"));
        file.write(std::string(100000, 'x'));
        file.publish();
    };
    try {
        writeMuch();
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot write '" + directory.file("result.dat") + "': File too large");
    }
    EXPECT_EQ(directory.read("result.dat"), "older result");
    EXPECT_FALSE(std::filesystem::exists(directory.file("result.dat.part")));
}

TEST(OutputFile, directory_that_cannot_be_made_is_reported) {
    const TemporaryDirectory directory;
    directory.write("file", "");
    try {
        OutputFile file(directory.file("file/result.dat"));
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("Not a directory"), std::string::npos)
            << error.what();
    }
}

} // namespace tokay
