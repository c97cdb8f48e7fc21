// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/loads/FaceSizes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tokay::mapper {

namespace {

// Rounding of sides that match must not count as larger.
constexpr double matching = 1 + 1e-6;

template <class SizeOfFace>
FaceSizes collectSizes(const FaceMesh& mesh, SizeOfFace sizeOfFace) {
    FaceSizes sizes;
    sizes.smallest = std::numeric_limits<double>::infinity();
    for (const std::vector<int>& face : mesh.faces) {
        const double size = sizeOfFace(Points(mesh.vertices(face, Eigen::all)));
        sizes.smallest = std::min(sizes.smallest, size);
        sizes.largest = std::max(sizes.largest, size);
        sizes.nOverSpan += size > matching;
        ++sizes.nFaces;
    }
    return sizes;
}

double spanLength(const InterfaceCurve& curve, double xi) {
    const std::vector<double>& knots = curve.breakpoints();
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, xi);
    return (*above - *(above - 1)) * curve.derivatives(xi, 1).row(1).norm();
}

double spanArea(const geometry::TrimmedPatch& patch, double xi, double eta) {
    const Points d = patch.basis().derivatives(xi, eta, 1);
    return patch.elementBox(patch.elementAt({xi, eta})).size().prod() *
           Point(d.row(1)).cross(Point(d.row(2))).norm();
}

double areaOf(const Points& corners) {
    Point area = Point::Zero();
    for (Eigen::Index i = 1; i + 1 < corners.rows(); ++i) {
        area += 0.5 * Point(corners.row(i) - corners.row(0))
                          .cross(Point(corners.row(i + 1) - corners.row(0)));
    }
    return area.norm();
}

} // namespace

FaceSizes faceSizes(const CurveInterface& splines, const FaceMesh& mesh) {
    return collectSizes(mesh, [&](const Points& corners) {
        const CurveInterface::Projection found = splines.closest(corners.colwise().mean());
        return (corners.bottomRows(1) - corners.topRows(1)).norm() /
               spanLength(splines.curve(found.piece), found.onCurve.xi);
    });
}

FaceSizes faceSizes(const SurfaceInterface& splines, const FaceMesh& mesh) {
    return collectSizes(mesh, [&](const Points& corners) {
        const SurfaceInterface::Projection found = splines.closest(corners.colwise().mean());
        return std::sqrt(areaOf(corners) / spanArea(splines.piece(found.piece).patch,
                                                    found.onSurface.xi, found.onSurface.eta));
    });
}

} // namespace tokay::mapper
