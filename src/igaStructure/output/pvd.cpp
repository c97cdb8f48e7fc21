// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/pvd.hpp"

#include "common/OutputFile.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

namespace tokay::structure {

namespace {

// The value of an XML attribute of a line; empty if it has none.
std::string attribute(const std::string& line, const std::string& name) {
    const std::string opening = " " + name + "=\"";
    const std::size_t place = line.find(opening);
    if (place == std::string::npos) {
        return "";
    }
    const std::size_t begin = place + opening.size();
    return line.substr(begin, line.find('"', begin) - begin);
}

} // namespace

void writePvd(const std::string& path, const std::vector<PvdEntry>& entries) {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n  <Collection>\n";
    for (const PvdEntry& entry : entries) {
        text += fmt::format("    <DataSet timestep=\"{:.12g}\" file=\"{}\"/>\n", entry.time,
                            entry.file);
    }
    OutputFile file(path);
    file.write(text + "  </Collection>\n</VTKFile>\n");
    file.publish();
}

std::vector<PvdEntry> readPvd(const std::string& path) {
    std::vector<PvdEntry> entries;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::string name = attribute(line, "file");
        if (!name.empty()) {
            entries.push_back({std::strtod(attribute(line, "timestep").c_str(), nullptr), name});
        }
    }
    return entries;
}

} // namespace tokay::structure
