// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/volumePrimitives.hpp"

#include "common/dense/DenseLu.hpp"
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/projection/BoxTree.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>

namespace tokay::geometry {

namespace {

/// Surface at a distance along the normal.
Point parallelPoint(const NurbsSurface& surface, double xi, double eta, double distance) {
    const Points d = surface.derivatives(xi, eta, 1);
    const Point a1 = d.row(1), a2 = d.row(2);
    return d.row(0).transpose() + distance * a1.cross(a2).normalized();
}

/// Farthest that one surface is from the parallel of another.
double deviation(const NurbsSurface& surface, const NurbsSurface& middle, double distance) {
    double largest = 0;
    for (int j = 0; j <= 10; ++j) {
        for (int i = 0; i <= 10; ++i) {
            const double s = 0.03 + 0.094 * i, t = 0.03 + 0.094 * j; // inside spans of halves too
            const double xi = (1 - s) * middle.u().first() + s * middle.u().last();
            const double eta = (1 - t) * middle.v().first() + t * middle.v().last();
            largest = std::max(
                largest,
                (surface.point(xi, eta) - parallelPoint(middle, xi, eta, distance)).norm());
        }
    }
    return largest;
}

/// The surface at a distance along the normal, by interpolation with the same functions.
NurbsSurface parallel(const NurbsSurface& middle, double distance) {
    const std::vector<double> xi = middle.u().grevilleAbscissae();
    const std::vector<double> eta = middle.v().grevilleAbscissae();
    const int n = middle.nControlPoints();
    Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(n, n);
    Points values(n, 3);
    for (std::size_t j = 0, row = 0; j < eta.size(); ++j) {
        for (std::size_t i = 0; i < xi.size(); ++i, ++row) {
            const SurfaceBasis basis = middle.basis(xi[i], eta[j], 0);
            for (std::size_t k = 0; k < basis.controlPoints.size(); ++k) {
                functions(row, basis.controlPoints[k]) = basis.N(0, k);
            }
            values.row(row) = parallelPoint(middle, xi[i], eta[j], distance).transpose();
        }
    }
    return middle.withControlPoints(DenseLu(functions).solve(values));
}

NurbsSurface exactParallel(const NurbsSurface& middle, double distance) {
    NurbsSurface surface = parallel(middle, distance);
    const double off = deviation(surface, middle, distance);
    const double rounding = 1e-13 * Box::around(middle.controlPoints()).diagonal();
    if (!(off <= 1e-9 * std::abs(distance) + rounding)) {
        throw InputError(fmt::format("the surface cannot be thickened exactly: its parallel at "
                                     "{:g} m would be off by {:.2g} m; a plane, a cylinder and a "
                                     "sphere can be; give others as a volume",
                                     distance, off));
    }
    return surface;
}

} // namespace

NurbsVolume block(const Point& origin, const Point& size) {
    const NurbsSurface base = rectangle(origin, size[0], size[1]);
    if (!(size[2] > 0) || !std::isfinite(size[2])) {
        throw InputError(
            fmt::format("the size of the block along z is {}: it must be positive", size[2]));
    }
    Points points(8, 3);
    points << base.controlPoints(),
        base.controlPoints().rowwise() + Eigen::RowVector3d(0, 0, size[2]);
    return NurbsVolume(base.u(), base.v(), KnotVector::uniform(1, 1), points);
}

NurbsVolume thickened(const NurbsSurface& middle, double thickness) {
    if (!(thickness > 0) || !std::isfinite(thickness)) {
        throw InputError(fmt::format("the thickness is {}: it must be positive", thickness));
    }
    const NurbsSurface back = exactParallel(middle, -0.5 * thickness);
    const NurbsSurface front = exactParallel(middle, 0.5 * thickness);
    Points points(2 * middle.nControlPoints(), 3);
    points << back.controlPoints(), front.controlPoints();
    Eigen::VectorXd weights(2 * middle.weights().size());
    weights << middle.weights(), middle.weights();
    return NurbsVolume(middle.u(), middle.v(), KnotVector::uniform(1, 1), points, weights);
}

} // namespace tokay::geometry
