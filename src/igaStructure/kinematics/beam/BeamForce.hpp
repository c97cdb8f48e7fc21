// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/beam/BeamDescription.hpp"
#include "igaStructure/kinematics/beam/BeamPoints.hpp"

namespace tokay::structure {

/// Forces on the control points of a beam that are equivalent to its loads
/// (same virtual work), x, y and in space z of each.
class BeamForce {
  public:
    /// @param dimension  2, or 3: without pressures and moments
    BeamForce(const geometry::NurbsCurve& curve, const BeamSection& section, BeamLoads loads,
              int dimension);

    /// Forces of the loads that keep their direction [N].
    Eigen::VectorXd dead(double time) const;

    bool hasFollowers() const { return hasFollowers_; }

    /// Forces of pressures and moments, which turn with the beam [N].
    /// @param displacement  of control points
    Eigen::VectorXd followers(double time, const Eigen::VectorXd& displacement) const;

    bool hasPressure() const { return !loads_.pressures.empty(); }
    /// True if all pressures are the same everywhere.
    bool hasUniformPressure() const;

    /// Calls add(element, matrix of its unknowns) with the derivative of the
    /// followers' forces.
    template <class Add>
    void visitFollowerTangents(double time, const Eigen::VectorXd& displacement, Add add) const;

  private:
    struct End {
        geometry::Point at;
        int first;
        Eigen::MatrixXd N;
        Eigen::Vector2d tangent;
    };
    const End& end(BeamEnd which) const { return ends_[which == BeamEnd::start ? 0 : 1]; }
    Eigen::Vector2d currentTangent(const End& end, const Eigen::VectorXd& displacement) const;
    Eigen::MatrixXd momentTangent(const EndLoad& load, double time,
                                  const Eigen::VectorXd& displacement) const;
    Eigen::MatrixXd pressureTangent(const BeamPoint& point, double pressure) const;
    double pressureAt(const BeamPoint& point, double time) const;

    BeamSection section_;
    BeamLoads loads_;
    int dimension_;
    std::vector<BeamPoint> points_;
    End ends_[2];
    int nUnknowns_;
    bool hasFollowers_;
};

template <class Add>
void BeamForce::visitFollowerTangents(double time, const Eigen::VectorXd& displacement,
                                      Add add) const {
    for (const EndLoad& load : loads_.ends) {
        if (load.moment) {
            add(load.end == BeamEnd::start ? 0 : points_.back().element,
                momentTangent(load, time, displacement));
        }
    }
    if (loads_.pressures.empty()) {
        return;
    }
    for (const BeamPoint& point : points_) {
        add(point.element, pressureTangent(point, pressureAt(point, time)));
    }
}

} // namespace tokay::structure
