// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/WetBoundary.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <cassert>

namespace tokay::structure {

using channel::Interface;
using geometry::Points;

namespace {

using PointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void requireDimension(const Body& body, const Interface& fluid) {
    if (fluid.dimension == static_cast<std::uint32_t>(body.dimension())) {
        return;
    }
    throw InputError(fmt::format(
        "the fluid's interface has {} dimensions, but the structure's kinematics needs {}{}",
        fluid.dimension, body.dimension(),
        body.dimension() == 2
            ? ": the fluid's mesh must be one cell thick with 'empty' front and back"
            : ""));
}

InterfaceFaces readFaces(const Body& body, const Interface& fluid) {
    requireDimension(body, fluid);
    return InterfaceFaces(fluid);
}

} // namespace

WetBoundary::WetBoundary(const Body& body, const Coupling& coupling, const Interface& fluid)
    : dimension_(body.dimension()), faces_(readFaces(body, fluid)),
      transfer_(isEdge() ? body.edgeTransfer(coupling, faces_.mesh())
                         : body.transfer(coupling, faces_.mesh())) {}

Eigen::VectorXd WetBoundary::components(const Points& ofPoints) const {
    const PointRows values = ofPoints.leftCols(dimension_);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

Eigen::VectorXd WetBoundary::displacements(const Eigen::VectorXd& displacement) const {
    return components(transfer_->displacements(displacement));
}

Eigen::MatrixXd WetBoundary::variations(const Eigen::VectorXd& displacement,
                                        const Eigen::MatrixXd& variations) const {
    Eigen::MatrixXd result(nComponents(), variations.cols());
    for (Eigen::Index k = 0; k < variations.cols(); ++k) {
        result.col(k) = components(transfer_->variation(displacement, variations.col(k)));
    }
    return result;
}

Points WetBoundary::onFaces(const Eigen::VectorXd& faceForces) const {
    assert(faceForces.size() == dimension_ * nFaces() && faceForces.allFinite());
    const Eigen::Map<const PointRows> given(faceForces.data(), nFaces(), dimension_);
    Points forces = Points::Zero(nFaces(), 3);
    forces.leftCols(dimension_) = given;
    return forces;
}

Eigen::VectorXd WetBoundary::faceCentre(int face) const {
    return faces_.means(points()).row(face).head(dimension_);
}

Eigen::VectorXd WetBoundary::forces(const Eigen::VectorXd& faceForces,
                                    const Eigen::VectorXd& displacement) const {
    return transfer_->forces(displacement, onFaces(faceForces));
}

} // namespace tokay::structure
