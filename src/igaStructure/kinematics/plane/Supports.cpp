// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/Supports.hpp"

namespace tokay::structure {

std::vector<bool> fixedUnknowns(const geometry::NurbsSurface& surface,
                                const std::vector<Support>& supports) {
    std::vector<bool> fixed(2 * surface.nControlPoints(), false);
    for (const Support& support : supports) {
        for (int k : surface.boundaryCurve(support.edge).controlPoints) {
            for (int c = 0; c < 2; ++c) {
                fixed[2 * k + c] = fixed[2 * k + c] || support.fixed[c];
            }
        }
    }
    return fixed;
}

} // namespace tokay::structure
