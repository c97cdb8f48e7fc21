// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgeCoupling.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace tokay::structure {

/// Ties the polynomials of a sliver to those of its neighbour, continued: the energy is
/// the square of their difference over the whole element, so functions of which trimming
/// leaves next to nothing are held by those of whole elements. Polynomials of the
/// patch's degree, rigid motions among them, cost nothing.
/// Source: Badia, Neiva & Verdugo 2022 (weak aggregation)
class GhostStabilisation : public EdgeCoupling {
  public:
    /// @param sliver, whole  elements
    /// @param tangential     stiffness along the surface, per area [N/m^3]
    /// @param normal         the same across it
    GhostStabilisation(const ShellPatch& patch, int sliver, int whole, double tangential,
                       double normal);

    Answer answer(const Eigen::VectorXd& displacement, Strains strains,
                  bool withTangent) const override;
    /// It holds no rigid motion.
    Eigen::MatrixXd restRows() const override;

  private:
    Eigen::MatrixXd stiffness_;
};

/// Stabilisation terms of the slivers of a patch.
/// @param membrane  E t / (1 - nu^2) [N/m]
/// @param bending   E t^3 / 12 / (1 - nu^2) [N m]; 0: a membrane
/// @param isTied    whether an element counts
std::vector<std::unique_ptr<EdgeCoupling>>
ghostStabilisations(const ShellPatch& patch, double membrane, double bending,
                    const std::function<bool(int element)>& isTied);

} // namespace tokay::structure
