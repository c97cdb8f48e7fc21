// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/VolumeProjector.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/kinematics/solid/Solid.hpp"

namespace tokay::structure {

/// A trivariate solid; the zeta of its locations is a parameter.
class SolidBody : public Body {
  public:
    explicit SolidBody(SolidDescription description);

    StructuralModel& model() override { return solid_; }
    const StructuralModel& model() const override { return solid_; }
    int dimension() const override { return 3; }
    std::string description() const override;
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override;

    Eigen::MatrixXd positions(const std::vector<Location>& locations) const override;
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const override;
    Closest closest(const geometry::Point& point) const override;
    /// Mass over half the surface: of a slender body, that of its section.
    double massPerWetArea() const override;
    double thickness() const override { return massPerWetArea() / solid_.material().density; }
    std::vector<std::string> advice() const override;

  private:
    WetSurface wetSurface(const std::vector<std::string>& names) const override;
    /// Cauchy's, in the order xx yy zz xy yz xz.
    Eigen::MatrixXd stress(const Eigen::VectorXd& displacement,
                           const std::vector<Location>& locations) const;
    /// Area of all six sides [m^2].
    double surfaceArea() const;

    Solid solid_;
    geometry::VolumeProjector projector_;
};

} // namespace tokay::structure
