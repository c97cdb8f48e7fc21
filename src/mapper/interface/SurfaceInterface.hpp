// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/SurfaceProjector.hpp"
#include "geometry/projection/surfacePoles.hpp"
#include "geometry/trimming/CurveOnSurface.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"
#include "mapper/Discretisation.hpp"

#include <array>

namespace tokay::mapper {

/// Patch of a structure's wet surface.
struct SurfacePiece {
    geometry::TrimmedPatch patch;
    /// Number in the structure of each control point of the patch's basis.
    std::vector<int> controlPoints;
    /// Name of the patch, for messages.
    std::string name;
};

/// The wet surface of a structure in space: trimmed NURBS patches that may share
/// control points. Values are the structure's control points, all of them.
class SurfaceInterface : public Discretisation {
  public:
    /// @param nControlPoints  of the whole structure
    /// @throws InputError if there is no patch, or its numbers do not fit
    SurfaceInterface(std::vector<SurfacePiece> pieces, int nControlPoints);

    int nPieces() const { return static_cast<int>(pieces_.size()); }
    const SurfacePiece& piece(int i) const { return pieces_[i]; }
    const geometry::SurfaceProjector& projector(int i) const { return projectors_[i]; }
    const geometry::Box& box(int i) const { return boxes_[i]; }
    /// True if the patch closes along xi, along eta (the seam of a cylinder).
    std::array<bool, 2> isClosed(int i) const { return isClosed_[i]; }

    /// Degenerate edges of the patch.
    const std::vector<geometry::Pole>& poles(int i) const { return poles_[i]; }

    int nValues() const override { return static_cast<int>(coordinates_.rows()); }
    /// Rows of control points of no patch are zero.
    const Points& coordinates() const override { return coordinates_; }
    double size() const override { return size_; }
    Location locate(const Point& point) const override;

    struct Projection {
        int piece;
        geometry::SurfaceProjection onSurface;
    };
    /// The closest place that is not trimmed away. If the closest place of a
    /// patch's surface is, the closest one on its loops stands for the patch.
    Projection closest(const Point& point) const;

    Functions functions(int piece, double xi, double eta) const;

    /// Knot spans of all patches, patch after patch.
    int nElements() const { return firstElement_.back(); }
    int elementNumber(int piece, int element) const { return firstElement_[piece] + element; }

  private:
    void addRim(const geometry::TrimmedPatch& patch);
    geometry::SurfaceProjection closestOn(int piece, const Point& point) const;

    std::vector<SurfacePiece> pieces_;
    std::vector<geometry::SurfaceProjector> projectors_;
    /// Curves of the loops of a trimmed patch, and a tree over their boxes.
    struct Rim {
        std::vector<geometry::CurveOnSurface> curves;
        std::unique_ptr<geometry::BoxTree> tree;
    };
    std::vector<Rim> rims_;
    std::vector<geometry::Box> boxes_;
    std::vector<std::array<bool, 2>> isClosed_;
    std::vector<std::vector<geometry::Pole>> poles_;
    std::vector<int> firstElement_;
    Points coordinates_;
    double size_;
    std::unique_ptr<geometry::BoxTree> tree_;
};

} // namespace tokay::mapper
