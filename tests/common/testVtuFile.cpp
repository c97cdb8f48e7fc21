// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/VtuFile.hpp"
#include "temporaryDirectory.hpp"
#include "vtuArrays.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tokay {

namespace {

/// A triangle and a line.
VtuFile exampleFile() {
    VtuFile file;
    file.beginPiece({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 1, 2}, {3, 5},
                    {VtkCell::triangle, VtkCell::line});
    return file;
}

} // namespace

TEST(VtuFile, keeps_every_array_to_the_last_bit) {
    const TemporaryDirectory directory;
    VtuFile file = exampleFile();
    file.addField(VtuFile::On::points, "pressure", 1, {1.0 / 3, 1e-300, -0.1});
    file.addField(VtuFile::On::cells, "face", {7, -1});
    file.write(directory.file("a.vtu"));
    const auto arrays = vtuArrays(directory.file("a.vtu"));
    EXPECT_EQ(arrays.at("pressure"), (std::vector<double>{1.0 / 3, 1e-300, -0.1}));
    EXPECT_EQ(arrays.at("face"), (std::vector<double>{7, -1}));
    EXPECT_EQ(arrays.at("connectivity"), (std::vector<double>{0, 1, 2, 1, 2}));
    EXPECT_EQ(arrays.at("offsets"), (std::vector<double>{3, 5}));
    EXPECT_EQ(arrays.at("types"), (std::vector<double>{5, 3}));
    EXPECT_EQ(arrays.at("Points"), (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(VtuFile, describes_itself_in_xml_whatever_the_names_are) {
    const TemporaryDirectory directory;
    VtuFile file = exampleFile();
    file.addField(VtuFile::On::points, "a<b & \"c\"", 1, {1, 2, 3});
    file.addTexts("names", {"left", "right"});
    file.write(directory.file("a.vtu"));
    const std::string text = directory.read("a.vtu");
    const std::string xml = text.substr(0, text.find("<AppendedData")) + "</VTKFile>\n";
    directory.write("a.xml", xml);
    EXPECT_EQ(std::system(("xmllint --noout " + directory.file("a.xml")).c_str()), 0) << xml;
    EXPECT_NE(xml.find("108 101 102 116 0 114"), std::string::npos) << "left, zero, r...";
}

} // namespace tokay
