// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/SurfaceProjector.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"

namespace tokay::structure {

/// A patch in the plane z = 0, in plane strain or plane stress.
class PlaneBody : public Body {
  public:
    explicit PlaneBody(PlaneSolid solid);

    StructuralModel& model() override { return solid_; }
    const StructuralModel& model() const override { return solid_; }
    int dimension() const override { return 2; }
    std::string description() const override;
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override;

    Eigen::MatrixXd positions(const std::vector<Location>& locations) const override;
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const override;
    Closest closest(const geometry::Point& point) const override;
    /// Mass per depth of the whole body over its largest extent.
    double massPerWetArea() const override;
    double thickness() const override { return massPerWetArea() / solid_.material().density; }
    std::vector<std::string> advice() const override;
    std::unique_ptr<const mapper::CurveInterface>
    edges(const std::vector<std::string>& names) const override {
        return std::make_unique<mapper::SplineInterface>(boundary(names));
    }

  private:
    mapper::SplineInterface boundary(const std::vector<std::string>& names) const;
    WetSurface wetSurface(const std::vector<std::string>& names) const override {
        return boundary(names);
    }
    double depth() const override { return solid_.material().thickness; }
    /// Cauchy's, in the order xx yy zz xy yz xz.
    Eigen::MatrixXd stress(const Eigen::VectorXd& displacement,
                           const std::vector<Location>& locations) const;

    PlaneSolid solid_;
    geometry::SurfaceProjector projector_;
};

} // namespace tokay::structure
