#include "geometry/TrimmedPatch.hpp"

#include "common/errors.hpp"
#include "geometry/refinement.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace tokay::geometry {

namespace {

ParameterBox parameterBox(const NurbsSurface& surface) {
    return {{surface.u().first(), surface.v().first()}, {surface.u().last(), surface.v().last()}};
}

/// A loop inside the box, points beyond its rim by rounding moved onto it.
TrimmingLoop keptInside(const TrimmingLoop& loop, const ParameterBox& box,
                        const std::string& patch) {
    constexpr double slack = 1e-9;
    std::vector<NurbsCurve> curves;
    bool moved = false;
    for (const NurbsCurve& curve : loop.curves()) {
        Points points = curve.controlPoints();
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const ParameterPoint point = points.row(i).head<2>();
            const ParameterPoint inside = point.cwiseMax(box.lower).cwiseMin(box.upper);
            if (((point - inside).cwiseAbs().array() > slack * box.size().array()).any())
                throw InputError(fmt::format(
                    "Patch \"{}\": a trimming curve has the control point ({:.9g}, {:.9g}), "
                    "outside "
                    "the parameter range {:.9g} to {:.9g}, {:.9g} to {:.9g}. Give trimming curves "
                    "in the parameters of the surface.",
                    patch, point[0], point[1], box.lower[0], box.upper[0], box.lower[1],
                    box.upper[1]));
            moved = moved || point != inside;
            points.row(i).head<2>() = inside;
        }
        curves.push_back(curve.withControlPoints(std::move(points)));
    }
    return moved ? TrimmingLoop(loop.kind(), std::move(curves)) : loop;
}

void checkArrangement(const std::vector<TrimmingLoop>& loops, const std::string& patch) {
    for (std::size_t i = 0; i < loops.size(); ++i)
        for (std::size_t j = i + 1; j < loops.size(); ++j)
            if (loops[i].meets(loops[j]))
                throw InputError(fmt::format("Patch \"{}\": trimming loops {} and {} cross or "
                                             "touch. Make one loop of them.",
                                             patch, i, j));
    for (std::size_t i = 0; i < loops.size(); ++i) {
        int around = 0;
        for (std::size_t j = 0; j < loops.size(); ++j)
            if (j != i)
                around += loops[j].winding(loops[i].pieces().front().start());
        const bool isHole = loops[i].kind() == LoopKind::inner;
        if (around != (isHole ? 1 : 0))
            throw InputError(fmt::format(
                "Patch \"{}\": {} trimming loop {} lies {}.", patch, isHole ? "inner" : "outer", i,
                isHole ? "outside the outer loops; holes must lie inside one"
                       : "inside another outer loop; only a hole may lie there"));
    }
}

std::vector<TrimmingLoop> checkedLoops(std::vector<TrimmingLoop> loops, const ParameterBox& box,
                                       const std::string& patch) {
    for (TrimmingLoop& loop : loops)
        loop = keptInside(loop, box, patch);
    const bool hasOuter = std::any_of(loops.begin(), loops.end(), [](const TrimmingLoop& loop) {
        return loop.kind() == LoopKind::outer;
    });
    if (!hasOuter)
        loops.insert(loops.begin(), TrimmingLoop::around(box));
    checkArrangement(loops, patch);
    return loops;
}

double insideArea(const std::vector<Tile>& tiles) {
    double area = 0;
    for (const Tile& tile : tiles)
        area += tile.area();
    return area;
}

} // namespace

TrimmedPatch::TrimmedPatch(NurbsSurface surface, std::string name)
    : TrimmedPatch(surface, surface, {TrimmingLoop::around(parameterBox(surface))}, false,
                   std::move(name)) {}

TrimmedPatch::TrimmedPatch(NurbsSurface surface, std::vector<TrimmingLoop> loops, std::string name)
    : TrimmedPatch(surface, surface, checkedLoops(std::move(loops), parameterBox(surface), name),
                   true, name) {}

TrimmedPatch::TrimmedPatch(NurbsSurface surface, NurbsSurface basis,
                           std::vector<TrimmingLoop> loops, bool isTrimmed, std::string name)
    : surface_(std::move(surface)), basis_(std::move(basis)), loops_(std::move(loops)),
      isTrimmed_(isTrimmed), name_(std::move(name)),
      grid_(basis_.u().breakpoints(), basis_.v().breakpoints()) {
    if (!isTrimmed_) {
        states_.assign(nElements(), ElementState::full);
        return;
    }
    std::vector<PlaneBezier> pieces;
    for (const TrimmingLoop& loop : loops_)
        pieces.insert(pieces.end(), loop.pieces().begin(), loop.pieces().end());
    sides_ = grid_.cut(pieces);
    leftWindings_ = grid_.leftWindings(sides_);
    findStates();
}

void TrimmedPatch::findStates() {
    states_.assign(nElements(), ElementState::none);
    for (int element = 0; element < nElements(); ++element) {
        if (sides_[element].empty() && leftWindings_[element].empty())
            continue;
        const ParameterBox box = elementBox(element);
        const double fraction =
            insideArea(elementTiles(box, sides_[element], leftWindings_[element])) / box.area();
        states_[element] = fraction <= sliver       ? ElementState::none
                           : fraction >= 1 - sliver ? ElementState::full
                                                    : ElementState::cut;
    }
}

TrimmedPatch TrimmedPatch::refined(int degreeU, int degreeV, int nDivisionsU,
                                   int nDivisionsV) const {
    return TrimmedPatch(surface_, refine(basis_, degreeU, degreeV, nDivisionsU, nDivisionsV),
                        loops_, isTrimmed_, name_);
}

std::vector<int> TrimmedPatch::elements(ElementState state) const {
    std::vector<int> found;
    for (int element = 0; element < nElements(); ++element)
        if (states_[element] == state)
            found.push_back(element);
    return found;
}

std::vector<Tile> TrimmedPatch::tiles(int element) const {
    const ParameterBox box = elementBox(element);
    if (state(element) == ElementState::full)
        return {{box.lower[1], box.upper[1], TileSide::straight(box.lower[0]),
                 TileSide::straight(box.upper[0])}};
    if (state(element) == ElementState::none)
        return {};
    return elementTiles(box, sides_[element], leftWindings_[element]);
}

bool TrimmedPatch::contains(const ParameterPoint& point) const {
    const ParameterBox all = box();
    if ((point.array() < all.lower.array()).any() || (point.array() > all.upper.array()).any())
        return false;
    const int element = elementAt(point);
    if (state(element) != ElementState::cut)
        return state(element) == ElementState::full;
    for (const Tile& tile : tiles(element))
        if (tile.etaFrom <= point[1] && point[1] <= tile.etaTo &&
            tile.left.xiAt(point[1]) <= point[0] && point[0] <= tile.right.xiAt(point[1]))
            return true;
    return false;
}

std::vector<Polygon> TrimmedPatch::tessellatedLoops(const ParameterPoint& chordTolerance) const {
    std::vector<Polygon> polygons;
    for (const TrimmingLoop& loop : loops_)
        polygons.push_back(loop.tessellated(chordTolerance));
    return polygons;
}

} // namespace tokay::geometry
