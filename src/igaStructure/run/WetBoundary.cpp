#include "igaStructure/run/WetBoundary.hpp"

#include "common/errors.hpp"
#include "coupling/PeerError.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::structure {

using coupling::Interface;
using coupling::PeerError;
using geometry::Points;

namespace {

using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

// That its arrays fit each other was checked when the message arrived.
void requirePlane(const Interface& fluid) {
    if (fluid.dimension != 2) {
        throw InputError(fmt::format(
            "the fluid's interface has {} dimensions, but planeStrain and planeStress need 2: the "
            "fluid's mesh must be one cell thick with 'empty' front and back",
            fluid.dimension));
    }
}

Points readPoints(const Interface& fluid) {
    requirePlane(fluid);
    const Eigen::Map<const Pairs> given(fluid.points.data(), fluid.points.size() / 2, 2);
    Points points = Points::Zero(given.rows(), 3);
    points.leftCols<2>() = given;
    return points;
}

Points meansOfFaces(const Interface& fluid, const Points& points) {
    const auto nFaces = static_cast<Eigen::Index>(fluid.faceOffsets.size()) - 1;
    Points centres = Points::Zero(nFaces, 3);
    for (Eigen::Index face = 0; face < nFaces; ++face) {
        const std::uint32_t begin = fluid.faceOffsets[face];
        const std::uint32_t end = fluid.faceOffsets[face + 1];
        if (begin == end) {
            throw PeerError(fmt::format("face {} of the fluid's interface has no points", face));
        }
        for (std::uint32_t k = begin; k < end; ++k) {
            centres.row(face) += points.row(fluid.facePoints[k]) / (end - begin);
        }
    }
    return centres;
}

mapper::SplineInterface wetEdges(const PlaneSolid& solid,
                                 const std::vector<geometry::Edge>& edges) {
    std::vector<mapper::SplinePiece> pieces;
    for (geometry::Edge edge : edges) {
        geometry::BoundaryCurve boundary = solid.surface().boundaryCurve(edge);
        pieces.push_back(
            {std::move(boundary.curve), std::move(boundary.controlPoints), geometry::nameOf(edge)});
    }
    return {std::move(pieces), solid.surface().nControlPoints()};
}

} // namespace

WetBoundary::WetBoundary(const PlaneSolid& solid, const Coupling& coupling, const Interface& fluid)
    : thickness_(solid.material().thickness), points_(readPoints(fluid)),
      faceCentres_(meansOfFaces(fluid, points_)), spline_(wetEdges(solid, coupling.interface)),
      toPoints_(spline_, points_, {coupling.gapLimit, true}),
      toFaces_(spline_, faceCentres_, {coupling.gapLimit, true}) {}

Eigen::VectorXd WetBoundary::displacements(const Eigen::VectorXd& ofUnknowns) const {
    const Eigen::Map<const Pairs> controlValues(ofUnknowns.data(), ofUnknowns.size() / 2, 2);
    const Pairs values = toPoints_.apply(controlValues);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

Eigen::VectorXd WetBoundary::forces(const std::vector<double>& onFaces) const {
    if (onFaces.size() != 2 * static_cast<std::size_t>(nFaces())) {
        throw PeerError(fmt::format("the fluid sent {} force components for {} faces",
                                    onFaces.size(), nFaces()));
    }
    const Eigen::Map<const Pairs> given(onFaces.data(), nFaces(), 2);
    for (int face = 0; face < nFaces(); ++face) {
        if (!given.row(face).allFinite()) {
            throw PeerError(fmt::format("the fluid's force on face {} at ({:.6g}, {:.6g}) is not "
                                        "finite: ({}, {}); the flow has diverged",
                                        face, faceCentres_(face, 0), faceCentres_(face, 1),
                                        given(face, 0), given(face, 1)));
        }
    }
    const Pairs values = thickness_ * toFaces_.applyTransposed(given);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

std::string WetBoundary::report() const {
    return "displacements at the fluid's points, " + toPoints_.report().text() +
           "forces from the fluid's faces, " + toFaces_.report().text();
}

} // namespace tokay::structure
