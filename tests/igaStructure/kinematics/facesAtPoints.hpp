// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/loads/LoadPoints.hpp"

namespace tokay::structure {

/// A face at each point, so that forces on faces are forces on points.
inline mapper::FaceMesh facesAtPoints(const geometry::Points& points) {
    mapper::FaceMesh mesh{points, {}};
    for (int i = 0; i < points.rows(); ++i) {
        mesh.faces.push_back({i});
    }
    return mesh;
}

} // namespace tokay::structure
