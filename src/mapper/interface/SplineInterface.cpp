// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/SplineInterface.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

namespace {

void checkNumbers(const SplinePiece& piece, int nControlPoints) {
    const int n = piece.curve.nControlPoints();
    if (static_cast<int>(piece.controlPoints.size()) != n) {
        throw InputError(fmt::format("the interface piece {} has {} control point numbers for a "
                                     "curve of {} control points",
                                     piece.name, piece.controlPoints.size(), n));
    }
    for (const int number : piece.controlPoints) {
        if (number < 0 || number >= nControlPoints) {
            throw InputError(
                fmt::format("the interface piece {} names the control point {}, but the "
                            "structure has {} (indices start at 0)",
                            piece.name, number, nControlPoints));
        }
    }
}

geometry::Box boxOf(const std::vector<SplinePiece>& pieces) {
    geometry::Box box = geometry::Box::empty();
    for (const SplinePiece& piece : pieces) {
        box.include(geometry::Box::around(piece.curve.controlPoints()));
    }
    return box;
}

/// Coordinates by the structure's numbers, once these are checked.
Points gathered(const std::vector<SplinePiece>& pieces, int nControlPoints) {
    const double size = boxOf(pieces).diagonal();
    Points coordinates = Points::Zero(nControlPoints, 3);
    std::vector<bool> isKnown(nControlPoints, false);
    for (const SplinePiece& piece : pieces) {
        checkNumbers(piece, nControlPoints);
        for (int i = 0; i < piece.curve.nControlPoints(); ++i) {
            const int number = piece.controlPoints[i];
            const auto here = piece.curve.controlPoints().row(i);
            const double distance = (coordinates.row(number) - here).norm();
            if (isKnown[number] && distance > 1e-9 * size) {
                throw InputError(
                    fmt::format("control point {} is shared by interface pieces, but in {} "
                                "it lies {:.3g} m from where the pieces before have it",
                                number, piece.name, distance));
            }
            coordinates.row(number) = here;
            isKnown[number] = true;
        }
    }
    return coordinates;
}

std::vector<std::unique_ptr<InterfaceCurve>> curvesOf(const std::vector<SplinePiece>& pieces) {
    std::vector<std::unique_ptr<InterfaceCurve>> curves;
    for (const SplinePiece& piece : pieces) {
        curves.push_back(interfaceCurve(piece.curve, piece.controlPoints));
    }
    return curves;
}

} // namespace

SplineInterface::SplineInterface(std::vector<SplinePiece> pieces, int nControlPoints)
    : CurveInterface(curvesOf(pieces), gathered(pieces, nControlPoints)),
      pieces_(std::move(pieces)) {}

} // namespace tokay::mapper
