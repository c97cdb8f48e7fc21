// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/Mapping.hpp"

namespace tokay::mapper {

/// n forces without symmetry, the same in every run.
Points probeForces(Eigen::Index n);

/// Maps forces by the transpose and enters in the report how well their sum and
/// their moment are kept.
/// @param forces  on the destination's values, nTo x 3
/// @param from    coordinates of the source's values, nFrom x 3 [m]
/// @param to      coordinates of the destination's values, nTo x 3 [m]
void measureConservation(const Mapping& mapping, const Points& forces, const Points& from,
                         const Points& to, MappingReport& report);

} // namespace tokay::mapper
