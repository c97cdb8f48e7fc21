#include "igaStructure/body/SolidTransfer.hpp"

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

} // namespace

SolidTransfer::SolidTransfer(const Solid& solid, const Coupling& coupling, const Points& points,
                             const Points& faceCentres)
    : sides_(wetSides(solid, coupling.interface)),
      toPoints_(sides_, points, {coupling.gapLimit, true}),
      toFaces_(sides_, faceCentres, {coupling.gapLimit, true}) {}

Points SolidTransfer::displacements(const Eigen::VectorXd& displacement) const {
    const Eigen::Map<const Points> controlValues(displacement.data(), displacement.size() / 3, 3);
    return toPoints_.apply(controlValues);
}

Eigen::VectorXd SolidTransfer::forces(const Eigen::VectorXd&, const Points& onFaces) const {
    const Points values = toFaces_.applyTransposed(onFaces);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

std::string SolidTransfer::report() const {
    return "displacements at the fluid's points, " + toPoints_.report().text() +
           "forces from the fluid's faces, " + toFaces_.report().text();
}

} // namespace tokay::structure
