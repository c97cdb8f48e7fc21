// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaces.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"

#include <cmath>
#include <numeric>

namespace tokay::benchmark {

namespace {

const Point holeCentre(0.47, 0.52, 0);
constexpr double holeRadius = 0.2;

double bend(double x) {
    return 0.2 * x * (1 - x);
}
double height(double x, double y) {
    return 1.6 * x * (1 - x) * y * (1 - y);
}

/// i / n, moved by up to a fifth of a step but for the ends.
double uneven(int i, int n, double phase) {
    return (i + (i == 0 || i == n ? 0 : 0.2 * std::sin(7.3 * i + phase))) / n;
}

Points grid(int n, int seed) {
    Points vertices((n + 1) * (n + 1), 3);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = uneven(i, n, 3.0 * j + seed), y = uneven(j, n, 2.0 * i - seed);
            vertices.row(i + (n + 1) * j) << x, y, height(x, y);
        }
    }
    return vertices;
}

std::vector<int> consecutive(int n) {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

} // namespace

mapper::CurveInterface lines(int n, int seed, mapper::ValuesAt valuesAt) {
    Points vertices(n + 1, 3);
    std::vector<std::array<int, 2>> elements;
    for (int i = 0; i <= n; ++i) {
        const double x = uneven(i, n, seed);
        vertices.row(i) << x, bend(x), 0;
        if (i > 0) {
            elements.push_back({i - 1, i});
        }
    }
    return mapper::lineMesh(vertices, elements, valuesAt);
}

mapper::SplineInterface curve(int degree, int nSpans) {
    const geometry::NurbsCurve line = geometry::line(Point(0, 0, 0), Point(1, 0, 0));
    const geometry::NurbsCurve base = refine(line, 2, 1);
    Points points = base.controlPoints();
    points(1, 1) = 0.1; // times 2 x (1 - x)
    const geometry::NurbsCurve refined = refine(base.withControlPoints(points), degree, nSpans);
    const int n = refined.nControlPoints();
    return mapper::SplineInterface({{refined, consecutive(n), "curve"}}, n);
}

mapper::SurfaceMesh quadrilaterals(int n, int seed, mapper::ValuesAt valuesAt) {
    mapper::SurfaceMesh::Faces faces;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = i + (n + 1) * j;
            faces.push_back({a, a + 1, a + n + 2, a + n + 1});
        }
    }
    return mapper::SurfaceMesh(grid(n, seed), faces, valuesAt);
}

mapper::SurfaceMesh triangles(int n, int seed, mapper::ValuesAt valuesAt) {
    mapper::SurfaceMesh::Faces faces;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = i + (n + 1) * j;
            faces.push_back({a, a + 1, a + n + 2});
            faces.push_back({a, a + n + 2, a + n + 1});
        }
    }
    return mapper::SurfaceMesh(grid(n, seed), faces, valuesAt);
}

mapper::SurfaceInterface patch(int degree, int n, Trimmed trimmed) {
    const geometry::NurbsSurface base =
        refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 1, 1);
    Points points = base.controlPoints();
    points(4, 2) = 0.4; // times 2 x (1 - x) 2 y (1 - y)
    const geometry::NurbsSurface surface =
        refine(base.withControlPoints(points), degree, degree, n, n);
    const int nControlPoints = surface.nControlPoints();
    std::vector<geometry::TrimmingLoop> loops;
    if (trimmed == Trimmed::hole) {
        const double turn = 2 * std::acos(-1.0);
        loops.push_back(geometry::TrimmingLoop::around({{0, 0}, {1, 1}}));
        loops.emplace_back(
            geometry::LoopKind::inner,
            std::vector{reversed(geometry::arc(holeCentre, holeRadius, 0.1, 0.1 + turn))});
    }
    geometry::TrimmedPatch trimmedPatch(surface, loops);
    return mapper::SurfaceInterface(
        {{std::move(trimmedPatch), consecutive(nControlPoints), "patch"}}, nControlPoints);
}

bool isInHole(const Point& point) {
    return std::hypot(point[0] - holeCentre[0], point[1] - holeCentre[1]) < holeRadius;
}

} // namespace tokay::benchmark
