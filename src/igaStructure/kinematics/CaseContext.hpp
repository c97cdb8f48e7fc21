// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::structure {

/// What a kinematics needs to know of the rest of the case file.
struct CaseContext {
    std::string directory; ///< of the case file
    bool isExplicit = false;
    bool isDynamic = false;
    bool isCoupled = false;
};

} // namespace tokay::structure
