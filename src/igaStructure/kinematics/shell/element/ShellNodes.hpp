// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"

#include <vector>

namespace tokay::structure {

/// Numbers of a shell's nodes: the control points of all patches, patch after patch.
/// The control points of an edge that is one point (a pole) are one node.
struct ShellNodes {
    explicit ShellNodes(const geometry::BrepModel& model);

    int count() const { return static_cast<int>(positions.rows()); }

    std::vector<std::vector<int>> ofFace; ///< node of each control point
    geometry::Points positions;
};

} // namespace tokay::structure
