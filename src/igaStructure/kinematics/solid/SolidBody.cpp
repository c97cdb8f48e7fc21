// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/SolidBody.hpp"

#include "igaStructure/kinematics/solid/SidePoints.hpp"
#include "igaStructure/kinematics/vonMises.hpp"
#include "igaStructure/output/volumeMesh.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

Vector3d parameters(const Location& location) {
    return {location.xi, location.eta, location.zeta};
}

// Descending, of stresses in the order xx yy zz xy yz xz.
MatrixXd principalStresses(const MatrixXd& stress) {
    MatrixXd values(3, stress.cols());
    for (Eigen::Index k = 0; k < stress.cols(); ++k) {
        const auto s = stress.col(k);
        Eigen::Matrix3d tensor;
        tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
        // Of fixed size: SymmetricEigen would allocate memory for each of them
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
        values.col(k) = solver.eigenvalues().reverse();
    }
    return values;
}

} // namespace

SolidBody::SolidBody(SolidDescription description)
    : solid_(std::move(description)), projector_(solid_.volume()) {
    add({"stress", "Pa", 6, true, [this](const MotionState& state, const auto& locations) {
             return stress(state.displacement, locations);
         }});
    add({"vonMisesStress", "Pa", 1, false, [this](const MotionState& state, const auto& locations) {
             return vonMises(stress(state.displacement, locations));
         }});
    add({"principalStress", "Pa", 3, false,
         [this](const MotionState& state, const auto& locations) {
             return principalStresses(stress(state.displacement, locations));
         }});
}

std::string SolidBody::description() const {
    const geometry::NurbsVolume& volume = solid_.volume();
    return fmt::format("  solid, {} strains, degree {} x {} x {}, {} x {} x {} elements{}{}\n"
                       "  {}, mass {:.4g} kg\n",
                       solid_.isLinear() ? "linear" : "nonlinear", volume.u().degree(),
                       volume.v().degree(), volume.w().degree(), volume.u().nSpans(),
                       volume.v().nSpans(), volume.w().nSpans(),
                       volume.isRational() ? ", rational" : "", solid_.nodes().description(),
                       solid_.material().description(), solid_.mass());
}

std::vector<VtuMesh> SolidBody::meshes(const OutputOptions& options) const {
    return {options.cells == CellShape::bezier
                ? bezierMesh(solid_.volume())
                : hexahedronMesh(solid_.volume(), options.subdivision)};
}

MatrixXd SolidBody::positions(const std::vector<Location>& locations) const {
    MatrixXd values(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        values.col(k) = solid_.volume().point(parameters(locations[k]));
    }
    return values;
}

MatrixXd SolidBody::displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const {
    MatrixXd values = MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const geometry::VolumeBasis basis = solid_.volume().basis(parameters(locations[k]));
        for (std::size_t a = 0; a < basis.controlPoints.size(); ++a) {
            values.col(k) += basis.N(0, static_cast<Eigen::Index>(a)) *
                             displacement.segment<3>(3 * solid_.nodes().of(basis.controlPoints[a]));
        }
    }
    return values;
}

MatrixXd SolidBody::stress(const Eigen::VectorXd& displacement,
                           const std::vector<Location>& locations) const {
    MatrixXd values(6, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const Eigen::Matrix3d s =
            solid_.stateAt(parameters(locations[k]), displacement).cauchyStress;
        values.col(k) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    }
    return values;
}

Body::Closest SolidBody::closest(const geometry::Point& point) const {
    const geometry::VolumeProjection found = projector_.closest(point);
    return {{0, found.parameters[0], found.parameters[1], found.parameters[2]}, found.distance};
}

double SolidBody::surfaceArea() const {
    double area = 0;
    for (int side = 0; side < 6; ++side) {
        const SidePoints points(solid_.volume(), static_cast<geometry::Side>(side));
        for (const SidePoints::SideElement& element : points.elements()) {
            for (const SidePoints::SidePoint& point : element.points) {
                area += point.weight * point.tangentXi.cross(point.tangentEta).norm();
            }
        }
    }
    return area;
}

double SolidBody::massPerWetArea() const {
    return solid_.mass() / (0.5 * surfaceArea());
}

std::vector<std::string> SolidBody::advice() const {
    const double slenderness = solid_.size() / thickness();
    constexpr double slender = 20; // shear then adds less than a percent
    return {fmt::format("slenderness (size over volume by half the surface) {:.3g}{}", slenderness,
                        slenderness > slender
                            ? ": a shell or a beam has the same motion with far fewer unknowns"
                            : "")};
}

WetSurface SolidBody::wetSurface(const std::vector<std::string>& names) const {
    std::vector<mapper::SurfacePiece> pieces;
    for (const std::string& name : names) {
        geometry::BoundarySurface boundary =
            solid_.volume().boundarySurface(geometry::sideFromName(name));
        pieces.push_back({geometry::TrimmedPatch(std::move(boundary.surface), name),
                          std::move(boundary.controlPoints), name});
    }
    return mapper::SurfaceInterface(std::move(pieces), solid_.volume().nControlPoints());
}

} // namespace tokay::structure
