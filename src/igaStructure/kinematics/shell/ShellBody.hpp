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
    const Shell& shell() const { return shell_; }
    int dimension() const override { return 3; }
    std::string description() const override;
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override;

    Eigen::MatrixXd positions(const std::vector<Location>& locations) const override;
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const override;
    Closest closest(const geometry::Point& point) const override;
    double massPerWetArea() const override;
    double thickness() const override;
    std::vector<std::string> advice() const override;
    /// Edges of the model, by name; of a shell without bending stiffness.
    std::unique_ptr<const mapper::CurveInterface>
    edges(const std::vector<std::string>& names) const override;

  private:
    using Locations = std::vector<Location>;

    WetSurface wetSurface(const std::vector<std::string>& names) const override;
    /// A resultant in the order 11, 22, 12, in the frame along the first parameter line.
    Eigen::MatrixXd resultant(Eigen::Vector3d ShellState::*of, const MotionState& state,
                              const Locations& locations) const;
    /// Larger and smaller principal stress [Pa].
    /// @param side  1: the top, where the normal points; -1: the bottom
    Eigen::MatrixXd principalStress(double side, const MotionState& state,
                                    const Locations& locations) const;
    /// Largest ratio over all faces.
    double largestThicknessOverRadius() const;

    Shell shell_;
    geometry::ModelProjector projector_;
};

} // namespace tokay::structure
