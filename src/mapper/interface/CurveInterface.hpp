// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/interface/InterfaceCurve.hpp"

#include <array>

namespace tokay::mapper {

/// An interface of a 2D scene: curves that together carry nValues() values.
class CurveInterface : public Discretisation {
  public:
    /// @param coordinates  nValues x 3; rows of values on no curve are not used
    /// @throws InputError if there is no curve
    CurveInterface(std::vector<std::unique_ptr<InterfaceCurve>> curves, Points coordinates);

    int nCurves() const { return static_cast<int>(curves_.size()); }
    const InterfaceCurve& curve(int i) const { return *curves_[i]; }

    int nValues() const override { return static_cast<int>(coordinates_.rows()); }
    const Points& coordinates() const override { return coordinates_; }
    double size() const override { return size_; }
    Location locate(const Point& point) const override;

    struct Projection {
        int piece;
        geometry::CurveProjection onCurve;
    };
    /// The closest place on any curve.
    Projection closest(const Point& point) const;

  private:
    std::vector<std::unique_ptr<InterfaceCurve>> curves_;
    Points coordinates_;
    double size_;
    std::unique_ptr<geometry::BoxTree> tree_;
};

/// Line elements with a value at each vertex, or one on each element (a face of a
/// finite volume mesh, constant over it).
/// @param vertices  n x 3 [m]
/// @param elements  first and last vertex of each
/// @throws InputError for an element without length or with a vertex that does
/// not exist, and if there is none
CurveInterface lineMesh(const Points& vertices, const std::vector<std::array<int, 2>>& elements,
                        ValuesAt valuesAt = ValuesAt::vertices);

} // namespace tokay::mapper
