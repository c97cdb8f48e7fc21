// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/ModelProjector.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"

namespace tokay::structure {

/// A Kirchhoff-Love shell or a membrane in space.
class ShellBody : public Body {
  public:
    explicit ShellBody(ShellDescription description);

    StructuralModel& model() override { return shell_; }
    const StructuralModel& model() const override { return shell_; }
    int dimension() const override { return 3; }
    std::string description() const override;
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override;

    /// membraneForce [N/m], bendingMoment [N]: 11, 22, 12 in the frame along the
    /// first parameter line; principalStressTop, principalStressBottom: larger and
    /// smaller one [Pa], top being where the normal points.
    std::vector<std::string> fieldNames() const override;
    std::vector<std::string> defaultFields() const override;
    Eigen::MatrixXd positions(const std::vector<Place>& places) const override;
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Place>& places) const override;
    Eigen::MatrixXd field(const std::string& name, const MotionState& state,
                          const std::vector<Place>& places) const override;
    Closest closest(const geometry::Point& point) const override;
    double massPerWetArea() const override;
    double thickness() const override;
    std::vector<std::string> advice() const override;
    std::unique_ptr<InterfaceTransfer> transfer(const Coupling& coupling,
                                                const geometry::Points& points) const override;

  private:
    double largestThicknessOverRadius() const;

    Shell shell_;
    geometry::ModelProjector projector_;
};

} // namespace tokay::structure
