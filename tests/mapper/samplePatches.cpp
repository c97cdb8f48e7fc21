// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplePatches.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"

#include <cmath>
#include <numeric>

namespace tokay::mapper {

namespace {
const double pi = std::acos(-1.0);
}

using geometry::LoopKind;
using geometry::NurbsSurface;
using geometry::TrimmedPatch;
using geometry::TrimmingLoop;

SurfaceInterface onePatch(TrimmedPatch patch) {
    const int n = patch.basis().nControlPoints();
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return SurfaceInterface({{std::move(patch), numbers, "patch"}}, n);
}

NurbsSurface plate(int nX, int nY) {
    return refine(geometry::rectangle(Point::Zero(), 2, 1), 2, 2, nX, nY);
}

NurbsSurface bentParameters(int nX, int nY) {
    NurbsSurface surface = refine(geometry::rectangle(Point::Zero(), 2, 1), 2, 2, 2, 2);
    Points points = surface.controlPoints();
    for (int j = 1; j < 3; ++j) {
        for (int i = 1; i < 3; ++i) {
            points.row(i + 4 * j) += Eigen::RowVector3d(0.2 * j - 0.3, 0.1 * i - 0.2, 0);
        }
    }
    return refine(surface.withControlPoints(points), 2, 2, nX / 2, nY / 2);
}

TrimmedPatch holedPlate(int nX, int nY) {
    return TrimmedPatch(
        plate(nX, nY),
        {TrimmingLoop::around({{0, 0}, {1, 1}}),
         TrimmingLoop(LoopKind::inner,
                      {reversed(geometry::arc(Point(0.45, 0.55, 0), 0.23, 0, 2 * pi))})});
}

SurfaceInterface twoPatches() {
    const NurbsSurface left = refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 2, 3);
    const NurbsSurface right = refine(geometry::rectangle(Point(1, 0, 0), 1, 1), 2, 2, 3, 3);
    const int nLeft = left.nControlPoints(), nU = left.u().nBasis();
    std::vector<int> leftNumbers(nLeft), rightNumbers(right.nControlPoints());
    std::iota(leftNumbers.begin(), leftNumbers.end(), 0);
    int next = nLeft;
    for (int j = 0; j < right.v().nBasis(); ++j) {
        for (int i = 0; i < right.u().nBasis(); ++i) {
            rightNumbers[i + right.u().nBasis() * j] = i == 0 ? nU - 1 + nU * j : next++;
        }
    }
    return SurfaceInterface(
        {{TrimmedPatch(left), leftNumbers, "left"}, {TrimmedPatch(right), rightNumbers, "right"}},
        next);
}

} // namespace tokay::mapper
