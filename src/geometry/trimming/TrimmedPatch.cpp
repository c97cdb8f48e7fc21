// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/TrimmedPatch.hpp"

#include "common/errors.hpp"
#include "geometry/spline/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

ParameterBox parameterBox(const NurbsSurface& surface) {
    return {{surface.u().first(), surface.v().first()}, {surface.u().last(), surface.v().last()}};
}

void checkInside(const TrimmingLoop& loop, const ParameterBox& box, const std::string& patch) {
    constexpr double slack = 1e-9;
    for (const PlaneBezier& piece : loop.pieces()) {
        const Parameters& point = piece.start(); // monotone pieces: none lies further out
        const Parameters inside = point.cwiseMax(box.lower).cwiseMin(box.upper);
        if (((point - inside).cwiseAbs().array() > slack * box.size().array()).any()) {
            throw InputError(fmt::format("patch \"{}\": a trimming curve reaches ({:.9g}, {:.9g}), "
                                         "outside the parameter range {:.9g} to {:.9g}, {:.9g} to "
                                         "{:.9g}; give trimming curves in the parameters of the "
                                         "surface",
                                         patch, point[0], point[1], box.lower[0], box.upper[0],
                                         box.lower[1], box.upper[1]));
        }
    }
}

void checkArrangement(const std::vector<TrimmingLoop>& loops, const std::string& patch) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
        for (std::size_t j = i + 1; j < loops.size(); ++j) {
            if (loops[i].meets(loops[j])) {
                throw InputError(
                    fmt::format("patch \"{}\": trimming loops {} and {} cross or touch; make "
                                "one loop of them",
                                patch, i, j));
            }
        }
    }
    for (std::size_t i = 0; i < loops.size(); ++i) {
        int around = 0;
        for (std::size_t j = 0; j < loops.size(); ++j) {
            if (j != i) {
                around += loops[j].winding(loops[i].pieces().front().start());
            }
        }
        const bool isHole = loops[i].kind() == LoopKind::inner;
        if (around != (isHole ? 1 : 0)) {
            throw InputError(fmt::format(
                "patch \"{}\": {} trimming loop {} lies {}", patch, isHole ? "inner" : "outer", i,
                isHole ? "outside the outer loops; holes must lie inside one"
                       : "inside another outer loop; only a hole may lie there"));
        }
    }
}

std::vector<TrimmingLoop> checkedLoops(std::vector<TrimmingLoop> loops, const ParameterBox& box,
                                       const std::string& patch) {
    for (const TrimmingLoop& loop : loops) {
        checkInside(loop, box, patch);
    }
    const bool hasOuter = std::any_of(loops.begin(), loops.end(), [](const TrimmingLoop& loop) {
        return loop.kind() == LoopKind::outer;
    });
    if (!hasOuter) {
        loops.insert(loops.begin(), TrimmingLoop::around(box));
    }
    checkArrangement(loops, patch);
    return loops;
}

bool trims(const std::vector<TrimmingLoop>& loops, const ParameterBox& box) {
    double area = 0;
    for (const TrimmingLoop& loop : loops) {
        area += loop.signedArea();
    }
    return area < (1 - TrimmedPatch::sliver) * box.area();
}

double insideArea(const std::vector<Tile>& tiles) {
    double area = 0;
    for (const Tile& tile : tiles) {
        area += tile.area();
    }
    return area;
}

} // namespace

TrimmedPatch::TrimmedPatch(NurbsSurface surface, std::string name)
    : TrimmedPatch(surface, surface, {TrimmingLoop::around(parameterBox(surface))},
                   std::move(name)) {}

TrimmedPatch::TrimmedPatch(NurbsSurface surface, std::vector<TrimmingLoop> loops, std::string name)
    : TrimmedPatch(surface, surface, checkedLoops(std::move(loops), parameterBox(surface), name),
                   name) {}

TrimmedPatch::TrimmedPatch(NurbsSurface surface, NurbsSurface basis,
                           std::vector<TrimmingLoop> loops, std::string name)
    : surface_(std::move(surface)), basis_(std::move(basis)), loops_(std::move(loops)),
      isTrimmed_(trims(loops_, parameterBox(surface_))), name_(std::move(name)),
      grid_(basis_.u().breakpoints(), basis_.v().breakpoints()) {
    tiles_.resize(nElements());
    polygons_.resize(nElements());
    states_.assign(nElements(), isTrimmed_ ? ElementState::empty : ElementState::full);
    if (isTrimmed_) {
        findTiles();
    }
}

void TrimmedPatch::findTiles() {
    std::vector<PlaneBezier> pieces;
    for (const TrimmingLoop& loop : loops_) {
        pieces.insert(pieces.end(), loop.pieces().begin(), loop.pieces().end());
    }
    const auto sides = grid_.cut(pieces);
    const auto leftWindings = grid_.leftWindings(sides);
    for (int element = 0; element < nElements(); ++element) {
        if (sides[element].empty() && leftWindings[element].empty()) {
            continue;
        }
        const ParameterBox box = elementBox(element);
        std::vector<Tile> tiles = elementTiles(box, sides[element], leftWindings[element]);
        const double fraction = insideArea(tiles) / box.area();
        if (fraction >= 1 - sliver) {
            states_[element] = ElementState::full;
        } else if (fraction > sliver) {
            states_[element] = ElementState::cut;
            for (const Tile& tile : tiles) {
                polygons_[element].push_back(tile.polygon(polygonTolerance * box.size()));
            }
            tiles_[element] = std::move(tiles);
        }
    }
}

TrimmedPatch TrimmedPatch::refined(int degreeU, int degreeV, int nDivisionsU,
                                   int nDivisionsV) const {
    return TrimmedPatch(surface_, refine(basis_, degreeU, degreeV, nDivisionsU, nDivisionsV),
                        loops_, name_);
}

std::vector<int> TrimmedPatch::elements(ElementState state) const {
    std::vector<int> found;
    for (int element = 0; element < nElements(); ++element) {
        if (states_[element] == state) {
            found.push_back(element);
        }
    }
    return found;
}

const std::vector<Tile>& TrimmedPatch::tiles(int element) const {
    return tiles_[element];
}

std::vector<Polygon> TrimmedPatch::clipped(const Polygon& cell) const {
    Parameters centre = Parameters::Zero();
    for (const Parameters& corner : cell) {
        centre += corner / static_cast<double>(cell.size());
    }
    std::vector<Polygon> parts;
    for (const Polygon& tile : polygons_[elementAt(centre)]) {
        Polygon part = clippedByConvex(tile, cell);
        if (part.size() >= 3) {
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

bool TrimmedPatch::contains(const Parameters& point) const {
    const ParameterBox all = box();
    if ((point.array() < all.lower.array()).any() || (point.array() > all.upper.array()).any()) {
        return false;
    }
    const int element = elementAt(point);
    if (state(element) != ElementState::cut) {
        return state(element) == ElementState::full;
    }
    for (const Tile& tile : tiles_[element]) {
        if (tile.etaFrom <= point[1] && point[1] <= tile.etaTo &&
            tile.left.xiAt(point[1]) <= point[0] && point[0] <= tile.right.xiAt(point[1])) {
            return true;
        }
    }
    return false;
}

std::vector<Polygon> TrimmedPatch::tessellatedLoops(const Parameters& chordTolerance) const {
    std::vector<Polygon> polygons;
    for (const TrimmingLoop& loop : loops_) {
        polygons.push_back(loop.tessellated(chordTolerance));
    }
    return polygons;
}

} // namespace tokay::geometry
