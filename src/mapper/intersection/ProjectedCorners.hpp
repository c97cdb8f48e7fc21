// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/SurfaceMesh.hpp"
#include "mapper/intersection/parameterPolygon.hpp"

namespace tokay::mapper {

/// The corners of a mesh in the parameter spaces of patches; what triangles
/// share is projected once.
class ProjectedCorners {
  public:
    /// Borrows both.
    ProjectedCorners(const SurfaceMesh& mesh, const SurfaceInterface& splines);

    /// @param i  0 to 2
    ProjectedCorner at(int triangle, int i, int piece);

  private:
    ProjectedCorner projected(int triangle, int i, int piece) const;

    /// Projection onto one patch; the next entry is that of the same vertex onto another.
    struct Entry {
        int piece, next;
        ProjectedCorner corner;
    };
    const SurfaceMesh& mesh_;
    const SurfaceInterface& splines_;
    /// Index of the first entry of each vertex; -1 if it has none.
    std::vector<int> first_;
    std::vector<Entry> entries_;
    /// The centre of a face belongs to that face's triangles only.
    int centre_ = -1;
    std::vector<Entry> ofCentre_;
};

} // namespace tokay::mapper
