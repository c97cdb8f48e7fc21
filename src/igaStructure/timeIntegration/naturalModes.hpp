// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Free undamped vibrations about the reference configuration, supports at rest.
struct NaturalModes {
    Eigen::VectorXd angularFrequencies; ///< ascending; 0 for rigid motions [rad/s]
    Eigen::MatrixXd shapes;             ///< unknowns, a column a mode; modal mass 1 kg
};

/// The lowest modes, K x = w^2 M x with K the tangent at rest, by Lanczos
/// iteration with the factored matrix K - shift M (Spectra, CHOLMOD). With an extension E,
/// of E^T K E and E^T M E.
/// @param count  at least 1
/// @throws InputError  if the structure has fewer free unknowns than count + 1
/// @throws SolverError if the iteration does not converge, or the structure
///                     buckles under its prestress
NaturalModes naturalModes(const StructuralModel& model, int count);

} // namespace tokay::structure
