// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlanePatchesBody.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/vonMises.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

namespace tokay::structure {

using Eigen::MatrixXd;

PlanePatchesBody::PlanePatchesBody(PlanePatchesCase description)
    : material_(description.material), membrane_(std::move(description.membrane)) {
    add({"stress", "Pa", 6, true, [this](const MotionState& state, const auto& locations) {
             return stress(state.displacement, locations);
         }});
    add({"vonMisesStress", "Pa", 1, false, [this](const MotionState& state, const auto& locations) {
             return vonMises(stress(state.displacement, locations));
         }});
}

std::string PlanePatchesBody::description() const {
    return fmt::format("  {} of {}, thickness {:g} m, as the membrane that has its stresses:\n{}",
                       material_.kinematics == Kinematics::planeStrain ? "plane strain"
                                                                       : "plane stress",
                       material_.description(), material_.thickness, membrane_.description());
}

Body::Closest PlanePatchesBody::closest(const geometry::Point& point) const {
    Closest found = membrane_.closest(point);
    found.location.zeta = 0;
    found.distance = (positions({found.location}).col(0) - point).norm();
    return found;
}

MatrixXd PlanePatchesBody::stress(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const {
    MatrixXd values(6, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const Location& at = locations[k];
        const Eigen::Matrix3d s = material_.cauchyStress(
            membrane_.shell().planeGradientAt(at.patch, {at.xi, at.eta}, displacement),
            membrane_.shell().description().strains);
        values.col(k) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    }
    return values;
}

double PlanePatchesBody::massPerWetArea() const {
    Eigen::VectorXd alongX = Eigen::VectorXd::Zero(model().nUnknowns());
    for (Eigen::Index k = 0; k < alongX.size(); k += model().nComponents()) {
        alongX[k] = 1;
    }
    return alongX.dot(model().massMatrix() * alongX) / (model().size() * material_.thickness);
}

std::vector<std::string> PlanePatchesBody::advice() const {
    return {
        fmt::format("slenderness (size over mean thickness) {:.3g}", model().size() / thickness())};
}

WetSurface PlanePatchesBody::wetSurface(const std::vector<std::string>& /*names*/) const {
    throw InputError("coupling: a fluid cannot be coupled to edges of a cad.json model in the "
                     "plane, only another structure (igaStructure couple); take a single patch "
                     "(geometry.rectangle or nurbs), or a shell or solid");
}

} // namespace tokay::structure
