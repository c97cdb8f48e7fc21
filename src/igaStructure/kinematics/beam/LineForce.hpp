// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/beam/LineLoads.hpp"
#include "igaStructure/kinematics/beam/LinePoints.hpp"
#include "igaStructure/kinematics/beam/LineSection.hpp"

namespace tokay::structure {

/// Forces on the control points of a line that are equivalent to its loads
/// (same virtual work), x, y and in space z of each.
class LineForce {
  public:
    /// @param dimension  2, or 3: without pressures and moments
    LineForce(const geometry::NurbsCurve& curve, const LineSection& section, LineLoads loads,
              int dimension);

    /// Of the loads that keep their direction [N].
    Eigen::VectorXd dead(double time) const;

    bool hasFollowers() const { return hasFollowers_; }

    /// Of pressures and moments, which turn with the line [N].
    /// @param displacement  of control points
    Eigen::VectorXd followers(double time, const Eigen::VectorXd& displacement) const;

    bool hasPressure() const { return !loads_.pressures.empty(); }
    /// Whether all pressures are the same everywhere.
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
    const End& end(LineEnd which) const { return ends_[which == LineEnd::start ? 0 : 1]; }
    Eigen::Vector2d currentTangent(const End& end, const Eigen::VectorXd& displacement) const;
    Eigen::MatrixXd momentTangent(const EndLoad& load, double time,
                                  const Eigen::VectorXd& displacement) const;
    Eigen::MatrixXd pressureTangent(const LinePoint& point, double pressure) const;
    double pressureAt(const LinePoint& point, double time) const;

    LineSection section_;
    LineLoads loads_;
    int dimension_;
    std::vector<LinePoint> points_;
    End ends_[2];
    int nUnknowns_;
    bool hasFollowers_;
};

template <class Add>
void LineForce::visitFollowerTangents(double time, const Eigen::VectorXd& displacement,
                                      Add add) const {
    for (const EndLoad& load : loads_.ends) {
        if (load.moment) {
            add(load.end == LineEnd::start ? 0 : points_.back().element,
                momentTangent(load, time, displacement));
        }
    }
    if (loads_.pressures.empty()) {
        return;
    }
    for (const LinePoint& point : points_) {
        add(point.element, pressureTangent(point, pressureAt(point, time)));
    }
}

} // namespace tokay::structure
