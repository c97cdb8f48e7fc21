// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/CurveProjector.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/kinematics/beam/Line.hpp"
#include "igaStructure/kinematics/beam/sectionMotion.hpp"

namespace tokay::structure {

/// A beam or cable. In the plane z = 0 it is as thick as its section: sections
/// move as rigid lines normal to the axis. In space it is its axis, for without
/// torsion nothing says how sections turn about it.
class LineBody : public Body {
  public:
    explicit LineBody(Line line) : line_(std::move(line)), projector_(line_.curve()) {}

    StructuralModel& model() override { return line_; }
    const StructuralModel& model() const override { return line_; }
    int dimension() const override { return line_.dimension(); }
    std::string description() const override;

    /// quads: the body over its thickness, in space straight pieces of its axis.
    /// bezier: its axis.
    std::vector<VtuMesh> meshes(const OutputOptions& options) const override;

    /// axialStress: along the axis, at the place in the thickness; in space on the axis.
    std::vector<std::string> fieldNames() const override;
    std::vector<std::string> defaultFields() const override;
    Eigen::MatrixXd positions(const std::vector<Place>& places) const override;
    Eigen::MatrixXd displacements(const Eigen::VectorXd& displacement,
                                  const std::vector<Place>& places) const override;
    Eigen::MatrixXd field(const std::string& name, const MotionState& state,
                          const std::vector<Place>& places) const override;
    Closest closest(const geometry::Point& point) const override;
    double massPerWetArea() const override { return line_.section().mass / line_.section().width; }
    double thickness() const override { return line_.section().thickness; }
    std::vector<std::string> advice() const override;
    std::unique_ptr<InterfaceTransfer> transfer(const Coupling& coupling,
                                                const geometry::Points& points) const override;

  private:
    bool isInPlane() const { return line_.dimension() == 2; }
    LineField reference(double xi) const;
    LineField evaluate(const Eigen::VectorXd& field, double xi) const;
    /// Of a field of control points on the axis, 3 x n.
    Eigen::MatrixXd axisValues(const Eigen::VectorXd& ofControlPoints,
                               const std::vector<Place>& places) const;
    Eigen::MatrixXd motion(const std::string& name, const MotionState& state,
                           const std::vector<Place>& places) const;
    double resultant(const std::string& name, const Eigen::VectorXd& displacement,
                     const Place& place) const;

    Line line_;
    geometry::CurveProjector projector_;
};

} // namespace tokay::structure
