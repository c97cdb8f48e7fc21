// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "geometry/trimming/CurveOnSurface.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"

#include <optional>

namespace tokay::geometry {

/// A face of a model.
struct BrepFace {
    TrimmedPatch patch;
    /// Curves in the parameter space that lie on the face without trimming it.
    std::vector<NurbsCurve> embeddedCurves = {};
};

/// A trimming curve as a side of an edge.
struct BrepTrim {
    int face;
    /// Index among the curves of the face: those of its loops in order, then
    /// the embedded ones.
    int curve;
    /// True if the trim runs as the edge does.
    bool isForward = true;
};

/// A line in space where faces meet (two trims) or end (one).
struct BrepEdge {
    std::string name;
    std::vector<BrepTrim> trims;
    /// The edge in space, if a file gives it.
    std::optional<NurbsCurve> curve = std::nullopt;
    /// Found by search, where a file does not say that its trims share an edge.
    bool isFound = false;
};

/// Boundary representation: trimmed patches and the edges between them.
class BrepModel {
  public:
    /// @param tolerance  gap at edges that the model is meant to have [m]; 0 if unknown
    /// @throws InputError if there is no face, names are not unique, or an edge
    /// names a face or curve that does not exist.
    /// @param remarks    what the reader of a file corrected or did not use, for the log
    explicit BrepModel(std::vector<BrepFace> faces, std::vector<BrepEdge> edges = {},
                       double tolerance = 0, std::vector<std::string> remarks = {});

    const std::vector<BrepFace>& faces() const { return faces_; }
    const std::vector<BrepEdge>& edges() const { return edges_; }
    const TrimmedPatch& patch(int face) const { return faces_[face].patch; }
    double tolerance() const { return tolerance_; }
    const std::vector<std::string>& remarks() const { return remarks_; }

    /// Largest extent of the control points [m].
    double size() const;

    /// @throws InputError that lists the names if there is no such face or edge.
    int faceNumber(const std::string& name) const;
    int edgeNumber(const std::string& name) const;

    int nCurves(int face) const;
    const NurbsCurve& curve(int face, int number) const;
    CurveOnSurface curveInSpace(const BrepTrim& trim) const;

    /// Copy of the model in a finer basis, as TrimmedPatch::refined.
    BrepModel refined(int degreeU, int degreeV, int nDivisionsU, int nDivisionsV) const;

  private:
    std::vector<BrepFace> faces_;
    std::vector<BrepEdge> edges_;
    double tolerance_;
    std::vector<std::string> remarks_;
};

/// True if the second curve runs as the first does, by their points.
bool runsAlong(const CurveOnSurface& first, const CurveOnSurface& second);

/// Edges between faces by search: trimming curves that coincide in space over
/// their whole length; each other curve is an edge of its own. Named
/// "face.curve", or "face.curve-face.curve".
/// @param tolerance  distance up to which curves coincide [m]
std::vector<BrepEdge> coincidentEdges(const std::vector<BrepFace>& faces, double tolerance);

/// The model with an edge more for each place where trimming curves coincide over their
/// whole length though they share no edge of the model.
/// @param tolerance  distance up to which curves coincide [m]
BrepModel withCoincidentEdges(const BrepModel& model, double tolerance);

} // namespace tokay::geometry
