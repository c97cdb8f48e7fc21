// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/SidePoints.hpp"

#include "igaStructure/assembly/TabulatedBasis.hpp"

namespace tokay::structure {

namespace {

constexpr int additionalSidePoints = 2;

TabulatedBasis tabulated(const geometry::KnotVector& knots) {
    return TabulatedBasis(knots, knots.degree() + additionalSidePoints);
}

SidePoints::SidePoint pointAt(const geometry::NurbsSurface& surface, double xi, double eta,
                              double weight) {
    const geometry::SurfaceBasis basis = surface.basis(xi, eta, 1);
    const geometry::Points d = basis.N * surface.controlPoints()(basis.controlPoints, Eigen::all);
    return {d.row(0), weight, d.row(1), d.row(2), basis.N};
}

} // namespace

SidePoints::SidePoints(const geometry::NurbsVolume& volume, geometry::Side side) {
    const geometry::BoundarySurface boundary = volume.boundarySurface(side);
    const geometry::NurbsSurface& surface = boundary.surface;
    outwards_ = boundary.pointsOutwards ? 1 : -1;
    const TabulatedBasis u = tabulated(surface.u());
    const TabulatedBasis v = tabulated(surface.v());
    for (int element = 0; element < u.nSpans() * v.nSpans(); ++element) {
        const int spanU = element % u.nSpans();
        const int spanV = element / u.nSpans();
        SideElement own;
        for (int k = 0; k < u.nPointsPerSpan() * v.nPointsPerSpan(); ++k) {
            const int i = k % u.nPointsPerSpan();
            const int j = k / u.nPointsPerSpan();
            own.points.push_back(pointAt(surface, u.parameter(spanU, i), v.parameter(spanV, j),
                                         u.weight(spanU, i) * v.weight(spanV, j)));
        }
        const auto middle = surface.basis(u.parameter(spanU, 0), v.parameter(spanV, 0), 0);
        for (int k : middle.controlPoints) {
            own.controlPoints.push_back(boundary.controlPoints[k]);
        }
        elements_.push_back(std::move(own));
    }
}

} // namespace tokay::structure
