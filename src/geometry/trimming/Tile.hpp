// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bezier/PlaneBezier.hpp"
#include "geometry/quadrature/Polygon.hpp"

#include <optional>

namespace tokay::geometry {

/// Left or right side of a tile: a piece of a trimming curve, rising in eta
/// over the tile's height, or a straight line xi = const.
struct TileSide {
    std::optional<PlaneBezier> curve;
    double xi = 0;

    static TileSide straight(double xi) { return {std::nullopt, xi}; }
    static TileSide curved(PlaneBezier curve) { return {std::move(curve), 0}; }

    double xiAt(double eta) const {
        return curve ? curve->point(curve->parameterAt(1, eta))[0] : xi;
    }
    double xiAtBottom() const { return curve ? curve->start()[0] : xi; }
    double xiAtTop() const { return curve ? curve->end()[0] : xi; }

    /// The part between two heights.
    TileSide part(double etaFrom, double etaTo) const;

    /// Integral of xi over the height.
    double integral(double height) const;
};

/// Part of an element between two heights and two sides that do not cross.
struct Tile {
    double etaFrom, etaTo;
    TileSide left, right;

    double height() const { return etaTo - etaFrom; }
    double area() const { return right.integral(height()) - left.integral(height()); }
    /// Counter-clockwise; its sides leave the curves by no more than the tolerance.
    Polygon polygon(const Parameters& chordTolerance) const;
    bool isRectangle() const { return !left.curve && !right.curve; }
};

/// Change of a winding number at a height.
struct WindingStep {
    double eta;
    int change;
};

/// Cuts the part of an element that lies inside the trimming loops into tiles.
/// @param sides        the pieces of trimming curves in the element, monotone
/// @param leftWinding  winding numbers just left of the element, from below
std::vector<Tile> elementTiles(const ParameterBox& element, const std::vector<PlaneBezier>& sides,
                               const std::vector<WindingStep>& leftWinding);

} // namespace tokay::geometry
