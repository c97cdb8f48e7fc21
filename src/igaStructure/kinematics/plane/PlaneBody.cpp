// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneBody.hpp"

#include "igaStructure/kinematics/thinness.hpp"
#include "igaStructure/kinematics/vonMises.hpp"

#include <fmt/format.h>

namespace tokay::structure {

PlaneBody::PlaneBody(PlaneSolid solid) : solid_(std::move(solid)), projector_(solid_.surface()) {
    add({"stress", "Pa", 6, true, [this](const MotionState& state, const auto& locations) {
             return stress(state.displacement, locations);
         }});
    add({"vonMisesStress", "Pa", 1, false, [this](const MotionState& state, const auto& locations) {
             return vonMises(stress(state.displacement, locations));
         }});
}

std::string PlaneBody::description() const {
    const geometry::NurbsSurface& surface = solid_.surface();
    const PlaneMaterial& material = solid_.material();
    return fmt::format(
        "  {}, {} strains, degree {} x {}, {} x {} elements{}{}\n"
        "  {}, thickness {:g} m\n",
        material.kinematics == Kinematics::planeStrain ? "plane strain" : "plane stress",
        solid_.isLinear() ? "linear" : "nonlinear", surface.u().degree(), surface.v().degree(),
        surface.u().nSpans(), surface.v().nSpans(), surface.isRational() ? ", rational" : "",
        solid_.nodes().description(), material.description(), material.thickness);
}

std::vector<VtuMesh> PlaneBody::meshes(const OutputOptions& options) const {
    return {options.cells == CellShape::bezier ? bezierMesh(solid_.surface())
                                               : quadMesh(solid_.surface(), options.subdivision)};
}

Eigen::MatrixXd PlaneBody::positions(const std::vector<Location>& locations) const {
    Eigen::MatrixXd values(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        values.col(k) = solid_.surface().point(locations[k].xi, locations[k].eta);
    }
    return values;
}

Eigen::MatrixXd PlaneBody::displacements(const Eigen::VectorXd& displacement,
                                         const std::vector<Location>& locations) const {
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const geometry::SurfaceBasis basis =
            solid_.surface().basis(locations[k].xi, locations[k].eta, 0);
        for (std::size_t a = 0; a < basis.controlPoints.size(); ++a) {
            values.col(k).head<2>() +=
                basis.N(0, a) *
                displacement.segment<2>(2 * solid_.nodes().of(basis.controlPoints[a]));
        }
    }
    return values;
}

Eigen::MatrixXd PlaneBody::stress(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const {
    Eigen::MatrixXd values(6, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const Eigen::Matrix3d s =
            solid_.stateAt(locations[k].xi, locations[k].eta, displacement).cauchyStress;
        values.col(k) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    }
    return values;
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
    return {fmt::format("slenderness (size over mean thickness) {:.3g}{}", slenderness,
                        slenderness > slender
                            ? fmt::format(": a beam has the same slow motion with far fewer "
                                          "unknowns; the frequency of its second bending mode "
                                          "is about {:.2g} % higher",
                                          100 * bendingOverestimate(slenderness, 2))
                            : "")};
}

mapper::SplineInterface PlaneBody::boundary(const std::vector<std::string>& names) const {
    std::vector<mapper::SplinePiece> pieces;
    for (const std::string& name : names) {
        geometry::BoundaryCurve boundary =
            solid_.surface().boundaryCurve(geometry::edgeFromName(name));
        pieces.push_back({std::move(boundary.curve), std::move(boundary.controlPoints), name});
    }
    return mapper::SplineInterface(std::move(pieces), solid_.surface().nControlPoints());
}

} // namespace tokay::structure
