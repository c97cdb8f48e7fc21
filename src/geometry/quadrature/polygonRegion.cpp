// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/polygonRegion.hpp"

#include <polyclipping/clipper.hpp>

#include <cmath>

namespace tokay::geometry {

namespace {

/// Clipper works on integers: a lattice of 2^52 steps over the extent, beyond
/// the resolution of the coordinates themselves.
class Lattice {
  public:
    Lattice(const Region& a, const Region& b) {
        Parameters lower = Parameters::Constant(HUGE_VAL), upper = -lower;
        for (const Region* region : {&a, &b}) {
            for (const Polygon& ring : *region) {
                for (const Parameters& point : ring) {
                    lower = lower.cwiseMin(point);
                    upper = upper.cwiseMax(point);
                }
            }
        }
        origin_ = lower;
        step_ = (upper - lower).cwiseMax(1e-300) * std::ldexp(1, -52);
    }

    ClipperLib::Paths paths(const Region& region) const {
        ClipperLib::Paths paths;
        for (const Polygon& ring : region) {
            ClipperLib::Path path;
            for (const Parameters& point : ring) {
                const Parameters steps = (point - origin_).cwiseQuotient(step_);
                path.emplace_back(std::llround(steps[0]), std::llround(steps[1]));
            }
            paths.push_back(std::move(path));
        }
        return paths;
    }

    Region region(const ClipperLib::Paths& paths) const {
        Region region;
        for (const ClipperLib::Path& path : paths) {
            Polygon ring;
            for (const ClipperLib::IntPoint& p : path) {
                ring.push_back(origin_ + step_.cwiseProduct(Parameters(static_cast<double>(p.X),
                                                                       static_cast<double>(p.Y))));
            }
            region.push_back(std::move(ring));
        }
        return region;
    }

  private:
    Parameters origin_, step_;
};

} // namespace

Region intersection(const Region& a, const Region& b) {
    if (a.empty() || b.empty()) {
        return {};
    }
    const Lattice lattice(a, b);
    ClipperLib::Clipper clipper;
    clipper.AddPaths(lattice.paths(a), ClipperLib::ptSubject, true);
    clipper.AddPaths(lattice.paths(b), ClipperLib::ptClip, true);
    ClipperLib::Paths common;
    clipper.Execute(ClipperLib::ctIntersection, common, ClipperLib::pftNonZero,
                    ClipperLib::pftNonZero);
    return lattice.region(common);
}

Region intersection(const Region& region, const ParameterBox& box) {
    const Polygon ring = {
        box.lower, {box.upper[0], box.lower[1]}, box.upper, {box.lower[0], box.upper[1]}};
    Region common = intersection(region, Region{ring});
    // Off the lattice, back onto the sides, so that neighbours share corners.
    const Parameters slack = 1e-13 * (box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()));
    for (Polygon& polygon : common) {
        for (Parameters& point : polygon) {
            for (int axis = 0; axis < 2; ++axis) {
                for (const double side : {box.lower[axis], box.upper[axis]}) {
                    if (std::abs(point[axis] - side) <= slack[axis]) {
                        point[axis] = side;
                    }
                }
            }
        }
    }
    return common;
}

double signedArea(const Region& region) {
    double area = 0;
    for (const Polygon& ring : region) {
        area += signedArea(ring);
    }
    return area;
}

} // namespace tokay::geometry
