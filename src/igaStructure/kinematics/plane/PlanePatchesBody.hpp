// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/plane/PlaneSolidCase.hpp"
#include "igaStructure/kinematics/shell/ShellBody.hpp"

namespace tokay::structure {

/// Trimmed patches in the plane z = 0, in plane strain or plane stress.
class PlanePatchesBody : public Body {
  public:
    explicit PlanePatchesBody(PlanePatchesCase description);

    StructuralModel& model() override { return membrane_.model(); }
    const StructuralModel& model() const override { return membrane_.model(); }
    int dimension() const override { return 2; }
    std::string description() const override;
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override {
        return membrane_.meshes(options);
    }

    Eigen::MatrixXd positions(const std::vector<Location>& locations) const override {
        return membrane_.positions(locations);
    }
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const override {
        return membrane_.displacements(displacement, locations);
    }
    Closest closest(const geometry::Point& point) const override;
    /// Mass per depth of the whole body over its largest extent.
    double massPerWetArea() const override;
    double thickness() const override { return massPerWetArea() / material_.density; }
    std::vector<std::string> advice() const override;
    std::unique_ptr<const mapper::CurveInterface>
    edges(const std::vector<std::string>& names) const override {
        return membrane_.edges(names);
    }

  private:
    /// @throws InputError  edges of trimmed patches are no interface of a fluid
    WetSurface wetSurface(const std::vector<std::string>& names) const override;
    double depth() const override { return material_.thickness; }
    /// Cauchy's, in the order xx yy zz xy yz xz.
    Eigen::MatrixXd stress(const Eigen::VectorXd& displacement,
                           const std::vector<Location>& locations) const;

    PlaneMaterial material_;
    ShellBody membrane_;
};

} // namespace tokay::structure
