// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tokay::mapper {

/// Vertices on the rim of a mesh, ascending: ends of a chain of edges that belong to one edge only,
/// vertices of a side that belongs to one face only. A closed mesh has none.
/// @param faces  vertices of each, in order around it; of two vertices: an edge of a plane scene
std::vector<int> rimVertices(const std::vector<std::vector<int>>& faces);

} // namespace tokay::mapper
