// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::mapper {

/// Where a mesh carries its values: a finite element mesh at its vertices, a
/// finite volume mesh on its faces.
enum class ValuesAt { vertices, faces };

} // namespace tokay::mapper
