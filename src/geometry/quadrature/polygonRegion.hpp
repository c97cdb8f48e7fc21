// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/quadrature/Polygon.hpp"
#include "geometry/spline/Points.hpp"

#include <array>

namespace tokay::geometry {

/// A region is a set of rings: outer ones counter-clockwise, holes clockwise.
using Region = std::vector<Polygon>;

/// The part of a region inside another, on a lattice of 2^-52 of their extent.
/// Rings may touch. By the Clipper library (Vatti's algorithm).
Region intersection(const Region& a, const Region& b);

/// The part of a region inside a rectangle.
Region intersection(const Region& region, const ParameterBox& box);

/// Positive: holes are subtracted.
double signedArea(const Region& region);

using PlaneTriangle = std::array<Parameters, 3>;

/// Triangles that cover a region, counter-clockwise, corners on its rings only.
std::vector<PlaneTriangle> triangulated(const Region& region);

} // namespace tokay::geometry
