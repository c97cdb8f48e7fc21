// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneBody.hpp"

#include "igaStructure/kinematics/plane/PlaneTransfer.hpp"
#include "igaStructure/kinematics/vonMises.hpp"

#include <fmt/format.h>

#include <cassert>

namespace tokay::structure {

std::string PlaneBody::description() const {
    const geometry::NurbsSurface& surface = solid_.surface();
    const Material& material = solid_.material();
    return fmt::format(
        "  {}, {} strains, degree {} x {}, {} x {} elements{}\n"
        "  St. Venant-Kirchhoff: E {:g} Pa, nu {:g}, density {:g} kg/m^3, thickness {:g} m\n",
        material.kinematics == Kinematics::planeStrain ? "plane strain" : "plane stress",
        solid_.isLinear() ? "linear" : "nonlinear", surface.u().degree(), surface.v().degree(),
        surface.u().nSpans(), surface.v().nSpans(), surface.isRational() ? ", rational" : "",
        material.youngsModulus, material.poissonsRatio, material.density, material.thickness);
}

std::vector<VtuMesh> PlaneBody::meshes(const OutputOptions& options) const {
    return {options.cells == CellShape::bezier ? bezierMesh(solid_.surface())
                                               : quadMesh(solid_.surface(), options.subdivision)};
}

std::vector<std::string> PlaneBody::fieldNames() const {
    return {"displacement", "velocity", "acceleration", "stress", "vonMisesStress"};
}

std::vector<std::string> PlaneBody::defaultFields() const {
    return {"displacement", "velocity", "stress"};
}

Eigen::MatrixXd PlaneBody::positions(const std::vector<Place>& places) const {
    Eigen::MatrixXd values(3, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        values.col(k) = solid_.surface().point(places[k].xi, places[k].eta);
    }
    return values;
}

Eigen::MatrixXd PlaneBody::displacements(const Eigen::VectorXd& displacement,
                                         const std::vector<Place>& places) const {
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(3, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const geometry::SurfaceBasis basis = solid_.surface().basis(places[k].xi, places[k].eta, 0);
        for (std::size_t a = 0; a < basis.controlPoints.size(); ++a) {
            values.col(k).head<2>() +=
                basis.N(0, a) * displacement.segment<2>(2 * basis.controlPoints[a]);
        }
    }
    return values;
}

Eigen::MatrixXd PlaneBody::stress(const Eigen::VectorXd& displacement,
                                  const std::vector<Place>& places) const {
    Eigen::MatrixXd values(6, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Eigen::Matrix3d s =
            solid_.stateAt(places[k].xi, places[k].eta, displacement).cauchyStress;
        values.col(k) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    }
    return values;
}

Eigen::MatrixXd PlaneBody::field(const std::string& name, const MotionState& state,
                                 const std::vector<Place>& places) const {
    if (name == "displacement") {
        return displacements(state.displacement, places);
    }
    if (name == "velocity") {
        return displacements(state.velocity, places); // linear in the unknowns
    }
    if (name == "acceleration") {
        return displacements(state.acceleration, places);
    }
    if (name == "stress") {
        return stress(state.displacement, places);
    }
    assert(name == "vonMisesStress");
    return vonMises(stress(state.displacement, places));
}

Body::Closest PlaneBody::closest(const geometry::Point& point) const {
    const geometry::SurfaceProjection found = projector_.closest(point);
    return {{0, found.xi, found.eta, 0}, found.distance};
}

double PlaneBody::massPerWetArea() const {
    Eigen::VectorXd alongX = Eigen::VectorXd::Zero(solid_.nUnknowns());
    for (Eigen::Index k = 0; k < alongX.size(); k += 2) {
        alongX[k] = 1;
    }
    return alongX.dot(solid_.massMatrix() * alongX) / (solid_.size() * solid_.material().thickness);
}

std::vector<std::string> PlaneBody::advice() const {
    const double slenderness = solid_.size() / thickness();
    constexpr double slender = 20; // shear then adds less than a percent
    return {fmt::format(
        "slenderness (size over mean thickness) {:.3g}{}", slenderness,
        slenderness > slender ? ": a beam has the same motion with far fewer unknowns" : "")};
}

std::unique_ptr<InterfaceTransfer> PlaneBody::transfer(const Coupling& coupling,
                                                       const geometry::Points& points) const {
    return std::make_unique<PlaneTransfer>(solid_, coupling, points);
}

} // namespace tokay::structure
