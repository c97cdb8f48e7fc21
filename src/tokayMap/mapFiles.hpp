// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tokayMap/MapOptions.hpp"

namespace tokay::tool {

/// Maps a field between two files and writes it.
/// @return what was done, for a person
/// @throws InputError, SolverError, OutputError
std::string mapFiles(const MapOptions& options);

} // namespace tokay::tool
