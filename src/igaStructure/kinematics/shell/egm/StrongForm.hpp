// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"
#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

#include <Eigen/Core>

#include <vector>

namespace tokay::structure {

/// The equilibrium of a linear shell or membrane at a point of its reference surface, in
/// strong form: L u + f = 0 with
///   L u = (n^ab A_b + S^ab u,b)|a + (m^ab A3)|ab,
/// n and m by the linear strains, S the prestress. Any parameters, any curvature.
///
/// Bending takes fourth derivatives. Those along an axis in which the patch has degree 3 are
/// all in the knots, where the third one jumps: a jump over the size of an element is the mean
/// of the fourth derivative around the knot, and between two knots it is taken to be linear.
struct StrongForm {
    /// @param face     material, thickness and prestress are its
    /// @param element  whose functions are taken, in its part that is trimmed away too; beside
    ///                 them those of its neighbours, where there are jumps
    StrongForm(const ShellDescription& description, int face, const ShellPatch& patch, int element,
               const geometry::Parameters& at);

    std::vector<int> nodes;
    Eigen::Vector3d position; ///< in the reference configuration [m]
    Eigen::Vector3d normal;
    double area;       ///< in space over that in the parameters
    Eigen::MatrixXd L; ///< 3 rows [N/m^3]; component c of node k is column 3 k + c

    /// Stiffnesses [N/m^3] over which a residual in the plane and one across it are
    /// displacements that an element of a size could have [m]; 0: none.
    double tangential(double elementSize) const;
    double across(double elementSize) const;

  private:
    double membrane_;  ///< [N/m]
    double bending_;   ///< [N m]
    double tension_;   ///< largest prestress times thickness [N/m]
    double curvature_; ///< root of the sum of squares of both [1/m]
};

} // namespace tokay::structure
