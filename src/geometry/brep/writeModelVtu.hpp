// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"

#include <string>

namespace tokay::geometry {

/// Writes a model for ParaView (.vtu): its faces in triangles and its edges in
/// lines, with the number of the face and of the edge as cell data (-1: none),
/// xi and eta as point data, and the names of both as field data.
/// @param chordTolerance  distance of triangles and lines to the model [m]; 0
///                        means a thousandth of the model's size
/// @throws OutputError if the file cannot be written.
void writeModelVtu(const BrepModel& model, const std::string& path, double chordTolerance = 0);

} // namespace tokay::geometry
