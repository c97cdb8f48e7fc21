// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"

#include <optional>
#include <string>

namespace tokay::geometry {

/// Reads the B-Rep files of Kratos' IGA application: faces with trimming loops
/// and embedded curves, edges with their topology. Faces and edges are named by
/// "brep_name", or else by the number "brep_id". Curves and surfaces may have
/// periodic knot vectors; "active_range" cuts curves. A face with
/// "swapped_surface_normal" is read with xi reversed, so that the normal of every
/// surface points where the face's does.
///
/// Loops that miss their joints or the rim of the surface by the tolerance are closed
/// (LoopSnapper). What was corrected, and what is not used (vertices, curves in space
/// that cannot be read, directions that contradict the curves) are the model's remarks.
/// @param tolerance  largest correction [length of the file]; if not given, the file's
///                   "model_tolerance", else 1e-6 of the size of the surface
/// @throws InputError with file, line and key for a file that is malformed or
/// describes no valid model. Gaps at edges are not checked: whoever joins faces does that.
/// Source: Teschemacher et al., Adv. Model. Simul. Eng. Sci. 5, 2018
BrepModel readCadJson(const std::string& path, std::optional<double> tolerance = std::nullopt);

/// Writes a model so that readCadJson reads the same one, to the last bit.
/// @throws OutputError if the file cannot be written.
void writeCadJson(const BrepModel& model, const std::string& path);

} // namespace tokay::geometry
