// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bezier/PlaneBezier.hpp"
#include "geometry/trimming/Tile.hpp"

namespace tokay::geometry {

/// The rectangles between knot lines, numbered i + nU * j, and how trimming
/// curves run through them.
class ElementGrid {
  public:
    /// @param xi, eta  knot lines, ascending
    ElementGrid(std::vector<double> xi, std::vector<double> eta);

    int nU() const { return static_cast<int>(xi_.size()) - 1; }
    int nV() const { return static_cast<int>(eta_.size()) - 1; }
    int nElements() const { return nU() * nV(); }
    ParameterBox box(int element) const;
    /// Box around all elements.
    ParameterBox box() const;
    /// Element that contains a point; beyond the rim the nearest. A point on a
    /// knot line belongs to the element after it.
    int elementAt(const Parameters& point) const;

    /// Pieces of curves cut at all knot lines, by the element that they lie in
    /// (one on a knot line belongs to either neighbour).
    /// @param pieces  monotone in both parameters
    std::vector<std::vector<PlaneBezier>> cut(const std::vector<PlaneBezier>& pieces) const;

    /// Winding numbers just left of each element.
    /// @param sides  as `cut` gives them
    std::vector<std::vector<WindingStep>>
    leftWindings(const std::vector<std::vector<PlaneBezier>>& sides) const;

  private:
    std::vector<double> xi_, eta_;
};

} // namespace tokay::geometry
