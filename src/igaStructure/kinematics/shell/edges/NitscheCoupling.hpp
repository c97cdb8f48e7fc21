// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgeCoupling.hpp"

#include <memory>
#include <vector>

namespace tokay::structure {

/// Terms of Nitsche's method at a point of an edge: the work of the tractions on the
/// constrained motion, subtracted, and a penalty just stiff enough that the energy
/// stays positive (linear strains).
/// Source: Benzaken, Evans, McCormick & Tamstorf 2021
class NitscheCoupling : public EdgeCoupling {
  public:
    /// @param nodes          each once
    /// @param held           displacement (3), its derivative along the edge (3) and the
    ///                       rotation about it (1): rows by the nodes' displacement
    /// @param traction       work-conjugate to them
    /// @param stabilisation  7 x 7
    /// @param mass           of the stabilisation against displacement [kg]
    NitscheCoupling(std::vector<int> nodes, Eigen::MatrixXd held, Eigen::MatrixXd traction,
                    Eigen::MatrixXd stabilisation, double mass);

    Answer answer(const Eigen::VectorXd& displacement, Strains strains,
                  bool withTangent) const override;
    /// Needs followAt().
    Shift shift(const VectorField& motion, double time) const override;
    void resistInertia(double massFactor) override;
    Eigen::MatrixXd restRows() const override { return held_; }

    /// Where the motion of a support is taken.
    /// @param step        along the edge, for its derivative; a part of an element [m]
    /// @param components  that are held
    void followAt(const Eigen::Vector3d& position, const Eigen::Vector3d& step,
                  const Eigen::Vector3d& components);

  private:
    Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d step_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d components_ = Eigen::Vector3d::Zero();
    Eigen::MatrixXd held_, traction_;
    Eigen::MatrixXd elastic_, stabilisation_; ///< without and with what resists inertia
    double mass_;
};

/// Terms of all points of an edge that is held or at which two patches meet. The
/// tractions of two sides are weighted so that the softer one counts; those of a
/// sliver are its neighbour's, continued.
/// Source of the weights: Annavarapu, Hautefeuille & Dolbow 2012
/// @param components  of the displacement, that are held
/// @param rotation    whether the rotation about the edge is held
/// @param bending     false: membranes
/// @param factor      on the stabilisation; below 1/3 it may not suffice
std::vector<std::unique_ptr<EdgeCoupling>> nitscheCouplings(const std::vector<EdgePoint>& points,
                                                            const std::array<bool, 3>& components,
                                                            bool rotation, bool bending,
                                                            double factor);

} // namespace tokay::structure
