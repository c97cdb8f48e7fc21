#include "igaStructure/body/PlaneTransfer.hpp"

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

} // namespace

PlaneTransfer::PlaneTransfer(const PlaneSolid& solid, const Coupling& coupling,
                             const Points& points, const Points& faceCentres)
    : thickness_(solid.material().thickness), spline_(wetEdges(solid, coupling.interface)),
      toPoints_(spline_, points, {coupling.gapLimit, true}),
      toFaces_(spline_, faceCentres, {coupling.gapLimit, true}) {}

Points PlaneTransfer::displacements(const Eigen::VectorXd& displacement) const {
    const Eigen::Map<const Pairs> controlValues(displacement.data(), displacement.size() / 2, 2);
    Points values = Points::Zero(toPoints_.matrix().rows(), 3);
    values.leftCols<2>() = toPoints_.apply(controlValues);
    return values;
}

Eigen::VectorXd PlaneTransfer::forces(const Eigen::VectorXd&, const Points& onFaces) const {
    const Pairs values = thickness_ * toFaces_.applyTransposed(onFaces.leftCols<2>());
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

std::string PlaneTransfer::report() const {
    return "displacements at the fluid's points, " + toPoints_.report().text() +
           "forces from the fluid's faces, " + toFaces_.report().text();
}

} // namespace tokay::structure
