// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/CurveProjector.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/kinematics/beam/Beam.hpp"
#include "igaStructure/kinematics/beam/sectionMotion.hpp"

namespace tokay::structure {

/// A beam or cable. In the plane z = 0 it is as thick as its section: sections
/// move as rigid lines normal to the axis. In space it is its axis, for without
/// torsion nothing says how sections turn about it.
class BeamBody : public Body {
  public:
    explicit BeamBody(Beam beam);

    StructuralModel& model() override { return beam_; }
    const StructuralModel& model() const override { return beam_; }
    int dimension() const override { return beam_.dimension(); }
    std::string description() const override;

    /// quads: the body over its thickness, in space straight pieces of its axis.
    /// bezier: its axis.
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override;

    Eigen::MatrixXd positions(const std::vector<Location>& locations) const override;
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Location>& locations) const override;
    Closest closest(const geometry::Point& point) const override;
    double massPerWetArea() const override { return beam_.section().mass / beam_.section().width; }
    double thickness() const override { return beam_.section().thickness; }
    std::vector<std::string> advice() const override;

  private:
    WetSurface wetSurface(const std::vector<std::string>& names) const override;
    double depth() const override { return beam_.section().width; }
    Eigen::MatrixXd velocities(const MotionState& state,
                               const std::vector<Location>& locations) const override;
    Eigen::MatrixXd accelerations(const MotionState& state,
                                  const std::vector<Location>& locations) const override;

    bool isInPlane() const { return beam_.dimension() == 2; }
    BeamField reference(double xi) const;
    BeamField evaluate(const Eigen::VectorXd& field, double xi) const;
    /// Values on the axis of a field of control points, 3 x n.
    Eigen::MatrixXd axisValues(const Eigen::VectorXd& ofControlPoints,
                               const std::vector<Location>& locations) const;
    /// A field of one component that depends on the resultants at a location.
    BodyField resultant(std::string name, std::string unit, bool isDefault,
                        std::function<double(const BeamState&, const Location&)> value) const;
    double axialStress(const BeamState& state, const Location& location) const;

    Beam beam_;
    geometry::CurveProjector projector_;
};

} // namespace tokay::structure
