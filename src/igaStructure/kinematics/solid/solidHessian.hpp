// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/solid/ElasticLaw.hpp"

namespace tokay::structure {

using Matrix9d = Eigen::Matrix<double, 9, 9>;

/// Second derivative of the energy by the displacement gradient, whose component
/// (i, J) is number 3 J + i.
/// @param gradient         deformation gradient
/// @param geometricStress  second Piola-Kirchhoff; zero for linear strains [Pa]
Matrix9d solidHessian(const Eigen::Matrix3d& gradient, const ElasticResponse& response,
                      const Eigen::Matrix3d& geometricStress);

} // namespace tokay::structure
