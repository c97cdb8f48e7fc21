// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"
#include "geometry/projection/SurfaceProjector.hpp"

namespace tokay::geometry {

struct ModelProjection {
    int face;
    double xi, eta;
    /// Distance of the point to the model [m].
    double distance;
    /// False if Newton's iteration ended without meeting its tolerance.
    bool converged;
    /// Another place of the model is as near, to 1e-6 of the distance.
    bool ambiguous;
    /// The place lies on a trimming curve or the edge of the parameter range: on
    /// the rim of the face, be it the model's rim, a shared edge or a seam.
    bool isOnRim;
};

/// Statistics of the projections of a mesh's points.
struct ProjectionSummary {
    int nPoints = 0, nNotConverged = 0, nAmbiguous = 0, nOnRim = 0;
    double largestDistance = 0; ///< [m]
    int farthestPoint = -1;
};

/// Closest points of a trimmed patch: places that are trimmed away do not
/// count; points beyond the loops get the closest place on them.
class PatchProjector {
  public:
    /// Borrows the patch.
    explicit PatchProjector(const TrimmedPatch& patch);

    /// @return with face = 0
    ModelProjection closest(const Point& point) const;

    const Box& box() const { return box_; }

  private:
    bool isOnRectangle(const SurfaceProjection& place) const;
    ModelProjection closestOnLoops(const Point& point) const;

    const TrimmedPatch& patch_;
    SurfaceProjector surface_;
    std::vector<CurveOnSurface> curves_;
    Box box_;
};

/// Closest points of a model of trimmed patches, by a tree over the faces and
/// one over each face's pieces. Seams, poles, C0 lines, corners and points near
/// the medial surface are found or flagged as SurfaceProjector does.
class ModelProjector {
  public:
    /// Borrows the model.
    explicit ModelProjector(const BrepModel& model);

    ModelProjection closest(const Point& point) const;

    /// Closest points of all rows.
    std::vector<ModelProjection> closestOfAll(const Points& points) const;

  private:
    const BrepModel& model_;
    std::vector<PatchProjector> faces_;
    double size_;
    std::unique_ptr<BoxTree> tree_;
};

ProjectionSummary summary(const std::vector<ModelProjection>& projections);

} // namespace tokay::geometry
