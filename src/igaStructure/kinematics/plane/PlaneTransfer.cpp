// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneTransfer.hpp"

namespace tokay::structure {

using geometry::Points;

namespace {

using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

mapper::SplineInterface wetEdges(const PlaneSolid& solid, const std::vector<std::string>& edges) {
    std::vector<mapper::SplinePiece> pieces;
    for (const std::string& edge : edges) {
        geometry::BoundaryCurve boundary =
            solid.surface().boundaryCurve(geometry::edgeFromName(edge));
        pieces.push_back({std::move(boundary.curve), std::move(boundary.controlPoints), edge});
    }
    return {std::move(pieces), solid.surface().nControlPoints()};
}

Points inSpace(const Eigen::VectorXd& ofControlPoints) {
    Points values = Points::Zero(ofControlPoints.size() / 2, 3);
    values.leftCols<2>() =
        Eigen::Map<const Pairs>(ofControlPoints.data(), ofControlPoints.size() / 2, 2);
    return values;
}

} // namespace

PlaneTransfer::PlaneTransfer(const PlaneSolid& solid, const Coupling& coupling,
                             const Points& points)
    : thickness_(solid.material().thickness), spline_(wetEdges(solid, coupling.interface)),
      toPoints_(spline_, points, {coupling.gapLimit, true}) {}

Points PlaneTransfer::displacements(const Eigen::VectorXd& displacement) const {
    return toPoints_.apply(inSpace(displacement));
}

Points PlaneTransfer::controlForces(const Eigen::VectorXd&, const Points& onPoints) const {
    return toPoints_.applyTransposed(onPoints);
}

Points PlaneTransfer::controlPoints(const Eigen::VectorXd& displacement) const {
    return spline_.coordinates() + inSpace(displacement);
}

Points PlaneTransfer::variation(const Eigen::VectorXd&, const Eigen::VectorXd& variation) const {
    return displacements(variation); // linear
}

Eigen::VectorXd PlaneTransfer::forces(const Eigen::VectorXd& displacement,
                                      const Points& onPoints) const {
    const Pairs values = thickness_ * controlForces(displacement, onPoints).leftCols<2>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

std::string PlaneTransfer::report() const {
    return "displacements of the fluid's points, " + toPoints_.report().text();
}

} // namespace tokay::structure
