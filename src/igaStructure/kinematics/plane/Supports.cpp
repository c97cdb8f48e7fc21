// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/Supports.hpp"

#include "igaStructure/kinematics/curvePoints.hpp"

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

SupportTrace supportTrace(const geometry::NurbsSurface& surface, const PatchNodes& nodes,
                          const std::vector<Support>& supports) {
    std::vector<Support> atRest;
    std::vector<Support> moving;
    std::vector<SupportPoint> points;
    for (const Support& support : supports) {
        (support.motion ? moving : atRest).push_back(support);
        if (support.motion) {
            const geometry::BoundaryCurve boundary = surface.boundaryCurve(support.edge);
            addCurvePoints(boundary.curve, nodes.of(boundary.controlPoints),
                           {support.fixed[0], support.fixed[1], false}, support.motion, points);
        }
    }
    return {std::move(points),
            movingOnly(nodes.fixed(fixedUnknowns(surface, moving)),
                       nodes.fixed(fixedUnknowns(surface, atRest))),
            2};
}

} // namespace tokay::structure
