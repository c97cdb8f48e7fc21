#include "igaStructure/body/ShellTransfer.hpp"

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

ShellTransfer::ShellTransfer(const Shell& shell, const Coupling& coupling, const Points& points,
                             const Points& faceCentres)
    : isLinear_(shell.isLinear()), middle_(middleSurface(shell)),
      toPoints_(middle_, points, {coupling.gapLimit, true}),
      toFaces_(middle_, faceCentres, {coupling.gapLimit, true}) {}

Points ShellTransfer::displacements(const Eigen::VectorXd& displacement) const {
    const Points values = ofNodes(displacement);
    return isLinear_ ? Points(toPoints_.apply(values)) : toPoints_.moved(values);
}

Eigen::VectorXd ShellTransfer::forces(const Eigen::VectorXd& displacement,
                                      const Points& onFaces) const {
    const Points forces = isLinear_ ? Points(toFaces_.applyTransposed(onFaces))
                                    : toFaces_.forces(ofNodes(displacement), onFaces);
    return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
}

std::string ShellTransfer::report() const {
    return "displacements at the fluid's points, " + toPoints_.report().text() +
           "forces from the fluid's faces, " + toFaces_.report().text();
}

} // namespace tokay::structure
