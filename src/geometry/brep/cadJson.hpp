// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"

#include <string>

namespace tokay::geometry {

/// Content of a cad.json file.
struct CadJson {
    BrepModel model;
    /// Remarks on entries that were read but not used, one each (vertices, directions of
    /// edges that contradict the curves).
    std::vector<std::string> notes;
};

/// Reads the B-Rep files of Kratos' IGA application: faces with trimming loops
/// and embedded curves, edges with their topology. Faces and edges are named by
/// "brep_name", or else by the number "brep_id". Curves and surfaces may have
/// periodic knot vectors; "active_range" cuts curves.
/// @throws InputError with file, line and key for a file that is malformed or
/// describes no valid model. Gaps at edges are not checked: BrepModel does that.
/// Source: Teschemacher et al., Adv. Model. Simul. Eng. Sci. 5, 2018
CadJson readCadJson(const std::string& path);

/// Writes a model so that readCadJson reads the same one, to the last bit.
/// @throws OutputError if the file cannot be written.
void writeCadJson(const BrepModel& model, const std::string& path);

} // namespace tokay::geometry
