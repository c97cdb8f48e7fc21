// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/ShellTransfer.hpp"

namespace tokay::structure {

using geometry::Points;

namespace {

mapper::SurfaceInterface middleSurface(const Shell& shell) {
    std::vector<mapper::SurfacePiece> pieces;
    for (const auto& patch : shell.patches()) {
        pieces.push_back({patch->patch(), patch->nodes(), patch->patch().name()});
    }
    return {std::move(pieces), shell.nodes().count()};
}

Eigen::Map<const Points> ofNodes(const Eigen::VectorXd& displacement) {
    return {displacement.data(), displacement.size() / 3, 3};
}

} // namespace

ShellTransfer::ShellTransfer(const Shell& shell, const Coupling& coupling, const Points& points)
    : isLinear_(shell.isLinear()), middle_(middleSurface(shell)),
      toPoints_(middle_, points, {coupling.gapLimit, true}) {}

Points ShellTransfer::displacements(const Eigen::VectorXd& displacement) const {
    const Points values = ofNodes(displacement);
    return isLinear_ ? Points(toPoints_.apply(values)) : toPoints_.moved(values);
}

Points ShellTransfer::controlForces(const Eigen::VectorXd& displacement,
                                    const Points& onPoints) const {
    return isLinear_ ? Points(toPoints_.applyTransposed(onPoints))
                     : toPoints_.forces(ofNodes(displacement), onPoints);
}

Points ShellTransfer::controlPoints(const Eigen::VectorXd& displacement) const {
    return middle_.coordinates() + ofNodes(displacement);
}

Points ShellTransfer::variation(const Eigen::VectorXd& displacement,
                                const Eigen::VectorXd& variation) const {
    const Points change = ofNodes(variation);
    return isLinear_ ? Points(toPoints_.apply(change))
                     : toPoints_.variation(ofNodes(displacement), change);
}

Eigen::VectorXd ShellTransfer::forces(const Eigen::VectorXd& displacement,
                                      const Points& onPoints) const {
    const Points forces = controlForces(displacement, onPoints);
    return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
}

std::string ShellTransfer::report() const {
    return "displacements of the fluid's points, " + toPoints_.report().text();
}

} // namespace tokay::structure
