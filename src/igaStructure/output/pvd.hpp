// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tokay::structure {

/// A file of a time series for ParaView.
struct PvdEntry {
    double time;      ///< [s]
    std::string file; ///< beside the .pvd file
};

/// @throws OutputError
void writePvd(const std::string& path, const std::vector<PvdEntry>& entries);

/// The entries of a file that writePvd wrote; none if there is no such file.
std::vector<PvdEntry> readPvd(const std::string& path);

} // namespace tokay::structure
