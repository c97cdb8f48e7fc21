// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"
#include "igaStructure/kinematics/shell/element/ShellNodes.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// Rigid motions that neither fixed unknowns nor couplings prevent, in words: of each part
/// where joints leave several.
std::vector<std::string> freeRigidMotions(const ShellDescription& description,
                                          const ShellNodes& nodes,
                                          const ShellConstraints& constraints);

/// Names of the parts, of several, of which nothing prevents any rigid motion.
std::vector<std::string> looseParts(const ShellDescription& description, const ShellNodes& nodes,
                                    const ShellConstraints& constraints);

} // namespace tokay::structure
