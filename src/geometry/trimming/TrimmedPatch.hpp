// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"
#include "geometry/trimming/ElementGrid.hpp"
#include "geometry/trimming/TrimmingLoop.hpp"

namespace tokay::geometry {

/// Part of an element that trimming leaves: all, some or none.
enum class ElementState { full, cut, empty };

/// Surface with trimming loops, and a basis on it that may be finer than the
/// surface's own. Elements are the knot spans of the basis, numbered
/// i + nElementsU * j.
class TrimmedPatch {
  public:
    /// A cut that takes, or leaves, no more than this fraction of an element
    /// counts as none: trim lines that miss a knot line by rounding.
    static constexpr double sliver = 1e-11;
    /// Chord tolerance of the polygons of cut elements, in element sizes.
    static constexpr double polygonTolerance = 1e-4;

    /// Untrimmed surface.
    explicit TrimmedPatch(NurbsSurface surface, std::string name = "patch");

    /// @param loops  outer and inner ones; without an outer one the rim of the
    ///               parameter rectangle is it. Curves up to 1e-9 of the range
    ///               outside of it are taken to lie on its rim.
    /// @throws InputError if a loop leaves the parameter rectangle, two loops meet,
    /// or a hole does not lie inside an outer loop.
    TrimmedPatch(NurbsSurface surface, std::vector<TrimmingLoop> loops, std::string name = "patch");

    /// Copy of the patch in a finer basis: degrees raised to those given, then
    /// each knot span cut into equal parts. The parameters keep their meaning.
    /// @throws InputError as refine
    TrimmedPatch refined(int degreeU, int degreeV, int nDivisionsU, int nDivisionsV) const;

    const std::string& name() const { return name_; }
    /// Surface as given.
    const NurbsSurface& surface() const { return surface_; }
    /// Surface in the refined basis.
    const NurbsSurface& basis() const { return basis_; }
    /// True if the loops leave out any of the parameter rectangle.
    bool isTrimmed() const { return isTrimmed_; }
    const std::vector<TrimmingLoop>& loops() const { return loops_; }

    int nElementsU() const { return grid_.nU(); }
    int nElementsV() const { return grid_.nV(); }
    int nElements() const { return grid_.nElements(); }
    int elementNumber(int i, int j) const { return i + nElementsU() * j; }
    ParameterBox elementBox(int element) const { return grid_.box(element); }
    int elementAt(const Parameters& point) const { return grid_.elementAt(point); }
    ParameterBox box() const { return grid_.box(); }
    ElementState state(int element) const { return states_[element]; }
    std::vector<int> elements(ElementState state) const;

    /// Part of a cut element inside the loops; empty for other elements.
    const std::vector<Tile>& tiles(int element) const;

    /// Part inside the loops of a convex cell that lies in one cut element:
    /// polygons whose signed areas add up, chords no further from the loops than
    /// polygonTolerance times the element's size.
    std::vector<Polygon> clipped(const Polygon& cell) const;

    /// True if a point lies inside; on the rim, to rounding, either result is right.
    bool contains(const Parameters& point) const;

    /// The loops as polygons, chords no further from them than the tolerance
    /// (in units of the parameters, for each direction).
    std::vector<Polygon> tessellatedLoops(const Parameters& chordTolerance) const;

  private:
    TrimmedPatch(NurbsSurface surface, NurbsSurface basis, std::vector<TrimmingLoop> loops,
                 std::string name);
    void findTiles();

    NurbsSurface surface_, basis_;
    std::vector<TrimmingLoop> loops_;
    bool isTrimmed_;
    std::string name_;
    ElementGrid grid_;
    std::vector<ElementState> states_;
    /// Parts of cut elements inside the loops: exact, and as polygons.
    std::vector<std::vector<Tile>> tiles_;
    std::vector<std::vector<Polygon>> polygons_;
};

} // namespace tokay::geometry
