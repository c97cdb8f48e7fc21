// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/polygonRegion.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tokay::geometry {

namespace {

double cross(const Parameters& a, const Parameters& b, const Parameters& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool isInside(const Parameters& p, const Parameters& a, const Parameters& b, const Parameters& c) {
    return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

std::size_t rightmost(const Polygon& ring) {
    const auto found = std::max_element(ring.begin(), ring.end(), [](const auto& a, const auto& b) {
        return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
    });
    return found - ring.begin();
}

/// Side of a ring that a ray from a point towards larger xi meets first.
struct RayHit {
    std::size_t ring = 0, side = 0;
    double xi = std::numeric_limits<double>::infinity();
};

RayHit rayHit(const Parameters& from, const std::vector<Polygon>& rings) {
    RayHit hit;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        for (std::size_t i = 0; i < rings[r].size(); ++i) {
            const Parameters &a = rings[r][i], &b = rings[r][(i + 1) % rings[r].size()];
            // Only sides that rise have the region on their left.
            if (a[1] > from[1] || b[1] < from[1] || a[1] == b[1]) {
                continue;
            }
            const double xi = a[0] + (from[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            if (xi >= from[0] && xi < hit.xi) {
                hit = {r, i, xi};
            }
        }
    }
    return hit;
}

/// Corner of the ring that the hole's corner sees, near where the ray hits.
/// Source: Eberly, Triangulation by ear clipping, section 3
std::size_t visibleCorner(const Parameters& from, const Polygon& ring, const RayHit& hit) {
    const std::size_t n = ring.size();
    std::size_t best =
        ring[hit.side][0] > ring[(hit.side + 1) % n][0] ? hit.side : (hit.side + 1) % n;
    const Parameters place(hit.xi, from[1]);
    Parameters corners[3] = {from, place, ring[best]};
    if (cross(corners[0], corners[1], corners[2]) < 0) {
        std::swap(corners[1], corners[2]);
    }
    double steepest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
        const bool isReflex = cross(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) < 0;
        const double right = ring[i][0] - from[0];
        if (!isReflex || right <= 0 || !isInside(ring[i], corners[0], corners[1], corners[2])) {
            continue;
        }
        const double steepness = std::abs(ring[i][1] - from[1]) / right;
        if (steepness < steepest) {
            steepest = steepness;
            best = i;
        }
    }
    return best;
}

/// Joins a hole to the ring around it by a bridge, there and back.
void join(const Polygon& hole, std::vector<Polygon>& rings) {
    const std::size_t start = rightmost(hole);
    const RayHit hit = rayHit(hole[start], rings);
    if (hit.xi == std::numeric_limits<double>::infinity()) {
        return; // a hole in nothing
    }
    Polygon& ring = rings[hit.ring];
    const std::size_t corner = visibleCorner(hole[start], ring, hit);
    Polygon bridged(ring.begin(), ring.begin() + corner + 1);
    for (std::size_t i = 0; i <= hole.size(); ++i) {
        bridged.push_back(hole[(start + i) % hole.size()]);
    }
    bridged.insert(bridged.end(), ring.begin() + corner, ring.end());
    ring = std::move(bridged);
}

/// Source: Eberly, Triangulation by ear clipping, section 2
void clipEars(const Polygon& ring, std::vector<PlaneTriangle>& triangles) {
    std::vector<std::size_t> left(ring.size());
    std::iota(left.begin(), left.end(), 0);
    const auto corner = [&](std::size_t i) { return ring[left[i % left.size()]]; };
    const auto isEar = [&](std::size_t i) {
        const std::size_t n = left.size();
        const Parameters a = corner(i + n - 1), b = corner(i), c = corner(i + 1);
        if (cross(a, b, c) <= 0) {
            return false;
        }
        for (std::size_t j = 0; j < n; ++j) {
            const Parameters p = corner(j);
            // Copies of the ear's corners (ends of bridges) do not count.
            if (p != a && p != b && p != c && isInside(p, a, b, c)) {
                return false;
            }
        }
        return true;
    };
    std::size_t at = 0;
    for (std::size_t failed = 0; left.size() >= 3; ++at) {
        at %= left.size();
        const std::size_t n = left.size();
        const Parameters a = corner(at + n - 1), b = corner(at), c = corner(at + 1);
        const bool isFlat = cross(a, b, c) == 0;
        // None is left only through rounding: then what is convex goes.
        const bool isForced = failed > n && (failed > 2 * n || cross(a, b, c) > 0);
        if (!isFlat && !isForced && !isEar(at)) {
            ++failed;
            continue;
        }
        if (cross(a, b, c) > 0) {
            triangles.push_back({a, b, c});
        }
        left.erase(left.begin() + at);
        failed = 0;
    }
}

} // namespace

std::vector<PlaneTriangle> triangulated(const Region& region) {
    std::vector<Polygon> rings, holes;
    for (const Polygon& ring : region) {
        (signedArea(ring) > 0 ? rings : holes).push_back(ring);
    }
    // From the right, so that a hole's ray meets only what is joined already.
    std::sort(holes.begin(), holes.end(), [](const Polygon& a, const Polygon& b) {
        return a[rightmost(a)][0] > b[rightmost(b)][0];
    });
    for (const Polygon& hole : holes) {
        join(hole, rings);
    }
    std::vector<PlaneTriangle> triangles;
    for (const Polygon& ring : rings) {
        clipEars(ring, triangles);
    }
    return triangles;
}

} // namespace tokay::geometry
