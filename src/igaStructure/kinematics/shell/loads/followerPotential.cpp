// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/loads/followerPotential.hpp"

#include <algorithm>

namespace tokay::structure {

namespace {

bool contains(const std::vector<geometry::BrepTrim>& trims, int face, int curve) {
    return std::any_of(trims.begin(), trims.end(), [&](const geometry::BrepTrim& trim) {
        return trim.face == face && trim.curve == curve;
    });
}

// Whether the surface goes on beyond the curve, under the same pressure.
bool isJoined(const ShellDescription& shell, const std::vector<int>& loaded, int face, int curve) {
    const auto& edges = shell.model.edges();
    return std::any_of(edges.begin(), edges.end(), [&](const geometry::BrepEdge& edge) {
        return edge.trims.size() > 1 && contains(edge.trims, face, curve) &&
               std::all_of(edge.trims.begin(), edge.trims.end(),
                           [&](const geometry::BrepTrim& trim) {
                               return std::count(loaded.begin(), loaded.end(), trim.face) > 0;
                           });
    });
}

// Extent of the curve along each axis over the size of the model.
Eigen::Vector3d extent(const ShellDescription& shell, int face, int curve) {
    const geometry::CurveOnSurface inSpace = shell.model.curveInSpace({face, curve});
    constexpr int nParts = 16;
    Eigen::Matrix<double, nParts + 1, 3> points;
    const double from = inSpace.breakpoints().front();
    const double to = inSpace.breakpoints().back();
    for (int k = 0; k <= nParts; ++k) {
        points.row(k) = inSpace.derivatives(from + (to - from) * k / nParts, 0).row(0);
    }
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()) / shell.model.size();
}

bool isHeld(const ShellDescription& shell, int face, int curve) {
    std::array<bool, 3> fixed = {false, false, false};
    for (const EdgeSupport& support : shell.edgeSupports) {
        for (int c = 0; c < 3 && contains(support.trims, face, curve); ++c) {
            fixed[c] = fixed[c] || support.fixed[c];
        }
    }
    const auto nFixed = std::count(fixed.begin(), fixed.end(), true);
    const auto axis = std::find(fixed.begin(), fixed.end(), true) - fixed.begin();
    constexpr double none = 1e-9;
    const Eigen::Vector3d extent = structure::extent(shell, face, curve);
    return nFixed >= 2 || (nFixed == 1 && extent[axis] < none) || extent.maxCoeff() < none;
}

bool isClosed(const ShellDescription& shell, const std::vector<int>& loaded, int face) {
    int nCurves = 0; // embedded ones follow
    for (const geometry::TrimmingLoop& loop : shell.model.patch(face).loops()) {
        nCurves += static_cast<int>(loop.curves().size());
    }
    for (int curve = 0; curve < nCurves; ++curve) {
        if (!isJoined(shell, loaded, face, curve) && !isHeld(shell, face, curve)) {
            return false;
        }
    }
    return true;
}

} // namespace

bool followersHavePotential(const ShellDescription& shell) {
    const auto hasPotential = [&](const ShellLoads::Pressure& load) {
        return !load.pressure.dependsOnPlace &&
               std::all_of(load.faces.begin(), load.faces.end(),
                           [&](int face) { return isClosed(shell, load.faces, face); });
    };
    const auto& pressures = shell.loads.pressures;
    return shell.loads.edgeMoments.empty() &&
           std::all_of(pressures.begin(), pressures.end(), hasPotential);
}

} // namespace tokay::structure
