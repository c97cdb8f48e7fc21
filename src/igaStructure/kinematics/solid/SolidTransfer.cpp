// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/SolidTransfer.hpp"

namespace tokay::structure {

using geometry::Points;

namespace {

mapper::SurfaceInterface wetSides(const Solid& solid, const std::vector<std::string>& sides) {
    std::vector<mapper::SurfacePiece> pieces;
    for (const std::string& side : sides) {
        geometry::BoundarySurface boundary =
            solid.volume().boundarySurface(geometry::sideFromName(side));
        pieces.push_back({geometry::TrimmedPatch(std::move(boundary.surface), side),
                          std::move(boundary.controlPoints), side});
    }
    return {std::move(pieces), solid.volume().nControlPoints()};
}

Eigen::Map<const Points> ofControlPoints(const Eigen::VectorXd& displacement) {
    return {displacement.data(), displacement.size() / 3, 3};
}

} // namespace

SolidTransfer::SolidTransfer(const Solid& solid, const Coupling& coupling, const Points& points)
    : sides_(wetSides(solid, coupling.interface)),
      toPoints_(sides_, points, {coupling.gapLimit, true}) {}

Points SolidTransfer::displacements(const Eigen::VectorXd& displacement) const {
    return toPoints_.apply(ofControlPoints(displacement));
}

Points SolidTransfer::controlForces(const Eigen::VectorXd&, const Points& onPoints) const {
    return toPoints_.applyTransposed(onPoints);
}

Points SolidTransfer::controlPoints(const Eigen::VectorXd& displacement) const {
    return sides_.coordinates() + ofControlPoints(displacement);
}

Points SolidTransfer::variation(const Eigen::VectorXd&, const Eigen::VectorXd& variation) const {
    return displacements(variation); // linear
}

Eigen::VectorXd SolidTransfer::forces(const Eigen::VectorXd& displacement,
                                      const Points& onPoints) const {
    const Points values = controlForces(displacement, onPoints);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

std::string SolidTransfer::report() const {
    return "displacements of the fluid's points, " + toPoints_.report().text();
}

} // namespace tokay::structure
