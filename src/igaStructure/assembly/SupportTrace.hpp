// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LatestValue.hpp"
#include "igaStructure/assembly/Field.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"

#include <Eigen/SparseCholesky>

#include <array>
#include <memory>
#include <vector>

namespace tokay::structure {

/// Displacement of a support by place and time [m]; none: it is at rest.
using SupportMotion = std::shared_ptr<const VectorField>;

/// A place of the body that follows the motion of a support.
struct SupportPoint {
    std::vector<int> nodes;
    Eigen::VectorXd N; ///< functions of the nodes
    double weight;     ///< in the fit
    geometry::Point position;
    std::array<bool, 3> components; ///< of the displacement, that follow
    SupportMotion motion;
};

/// Unknowns that moving supports prescribe: the best approximation of their motions on
/// the points, exact for motions that the basis holds there.
class SupportTrace {
  public:
    /// Of supports that are all at rest.
    SupportTrace() = default;

    /// @param moving       unknowns to find; component c of node k is nComponents k + c. Others
    ///                     that are not zero at the points are at rest.
    /// @param nComponents  2 or 3
    SupportTrace(std::vector<SupportPoint> points, const std::vector<bool>& moving,
                 int nComponents);

    bool isEmpty() const { return unknowns_.empty(); }

    /// Values of all unknowns at a time, 0 where nothing moves [m]. Not to be called by several
    /// threads at once: keeps the latest ones.
    Eigen::VectorXd at(double time) const;

  private:
    /// Values of unknowns_ at a time, by least squares [m].
    Eigen::VectorXd fitted(double time) const;
    /// Calls visit(number of the unknown, its function) for each that follows a component.
    template <class Visit>
    void forEachUnknown(const SupportPoint& point, int component, Visit visit) const;

    std::vector<SupportPoint> points_;
    int nComponents_ = 0;
    std::vector<int> unknowns_; ///< that move
    std::vector<int> numbers_;  ///< of each unknown among these; -1: none
    std::shared_ptr<Eigen::SimplicialLDLT<SparseMatrix>> matrix_;
    mutable LatestValue<Eigen::VectorXd> latest_; ///< of unknowns_
};

} // namespace tokay::structure
