// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/solidSupports.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/curvePoints.hpp"
#include "igaStructure/kinematics/solid/SidePoints.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

namespace tokay::structure {

namespace {

// Control points that lie on all of the sides.
std::vector<int> commonControlPoints(const geometry::NurbsVolume& volume,
                                     const std::vector<geometry::Side>& sides) {
    std::vector<int> common = volume.boundarySurface(sides.front()).controlPoints;
    for (geometry::Side side : sides) {
        const std::vector<int> own = volume.boundarySurface(side).controlPoints; // ascending
        std::vector<int> both;
        std::set_intersection(common.begin(), common.end(), own.begin(), own.end(),
                              std::back_inserter(both));
        common = std::move(both);
    }
    return common;
}

} // namespace

void requireCommonPoints(const geometry::NurbsVolume& volume,
                         const std::vector<geometry::Side>& sides) {
    if (commonControlPoints(volume, sides).empty()) {
        throw InputError("faces that do not meet have no common edge: a support of each of them "
                         "is an item of its own");
    }
}

std::vector<bool> fixedUnknowns(const geometry::NurbsVolume& volume,
                                const std::vector<SolidSupport>& supports) {
    std::vector<bool> fixed(3 * volume.nControlPoints(), false);
    for (const SolidSupport& support : supports) {
        for (int k : commonControlPoints(volume, support.sides)) {
            for (int c = 0; c < 3; ++c) {
                fixed[3 * k + c] = fixed[3 * k + c] || support.fixed[c];
            }
        }
    }
    return fixed;
}

namespace {

void addSidePoints(const SolidDescription& solid, const PatchNodes& nodes,
                   const SolidSupport& support, std::vector<SupportPoint>& points) {
    const SidePoints side(solid.volume, support.sides.front());
    for (const SidePoints::SideElement& element : side.elements()) {
        for (const SidePoints::SidePoint& at : element.points) {
            points.push_back({nodes.of(element.controlPoints), at.N.row(0),
                              at.weight * at.tangentXi.cross(at.tangentEta).norm(), at.position,
                              support.fixed, support.motion});
        }
    }
}

// Along the edge of a side that has these control points, given in ascending order.
void addEdgePoints(const SolidDescription& solid, const PatchNodes& nodes,
                   const SolidSupport& support, const std::vector<int>& edge,
                   std::vector<SupportPoint>& points) {
    const geometry::BoundarySurface side = solid.volume.boundarySurface(support.sides.front());
    for (const auto name : {geometry::Edge::left, geometry::Edge::right, geometry::Edge::bottom,
                            geometry::Edge::top}) {
        const geometry::BoundaryCurve boundary = side.surface.boundaryCurve(name);
        std::vector<int> own;
        for (const int k : boundary.controlPoints) {
            own.push_back(side.controlPoints[k]);
        }
        if (own == edge) {
            addCurvePoints(boundary.curve, nodes.of(own), support.fixed, support.motion, points);
        }
    }
}

void addPoints(const SolidDescription& solid, const PatchNodes& nodes, const SolidSupport& support,
               std::vector<SupportPoint>& points) {
    const std::vector<int> common = commonControlPoints(solid.volume, support.sides);
    if (support.sides.size() == 1) {
        addSidePoints(solid, nodes, support, points);
    } else if (common.size() > 1) {
        addEdgePoints(solid, nodes, support, common, points);
    } else if (common.size() == 1) {
        points.push_back({nodes.of(common), Eigen::VectorXd::Ones(1), 1,
                          solid.volume.controlPoints().row(common.front()), support.fixed,
                          support.motion});
    }
}

} // namespace

SupportTrace supportTrace(const SolidDescription& solid, const PatchNodes& nodes) {
    std::vector<SolidSupport> atRest;
    std::vector<SolidSupport> moving;
    std::vector<SupportPoint> points;
    for (const SolidSupport& support : solid.supports) {
        (support.motion ? moving : atRest).push_back(support);
        if (support.motion) {
            addPoints(solid, nodes, support, points);
        }
    }
    return {std::move(points),
            movingOnly(nodes.fixed(fixedUnknowns(solid.volume, moving)),
                       nodes.fixed(fixedUnknowns(solid.volume, atRest))),
            3};
}

namespace {

bool isHeld(const geometry::NurbsVolume& volume, const std::vector<int>& edge,
            const std::vector<bool>& fixed) {
    const geometry::Points points = volume.controlPoints()(edge, Eigen::all);
    const double length = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
    int nFixed = 0;
    bool acrossPlane = false;
    for (int c = 0; c < 3; ++c) {
        if (std::all_of(edge.begin(), edge.end(), [&](int k) { return fixed[3 * k + c]; })) {
            ++nFixed;
            const auto x = points.col(c);
            acrossPlane = acrossPlane || x.maxCoeff() - x.minCoeff() <= 1e-12 * length;
        }
    }
    return nFixed >= 2 || acrossPlane;
}

} // namespace

bool pressuresHavePotential(const SolidDescription& solid, const PatchNodes& nodes) {
    const std::vector<bool> fixed = fixedUnknowns(solid.volume, solid.supports);
    const std::vector<int>& closed = nodes.closedDirections();
    for (const SolidLoads::Pressure& load : solid.loads.pressures) {
        if (load.pressure.dependsOnPlace) {
            return false;
        }
        for (int number = 0; number < 6; ++number) {
            const auto other = static_cast<geometry::Side>(number);
            const bool isSeam = std::find(closed.begin(), closed.end(), number / 2) != closed.end();
            const bool isNeighbour = !isSeam && number / 2 != static_cast<int>(load.side) / 2;
            if (isNeighbour &&
                !isHeld(solid.volume, commonControlPoints(solid.volume, {load.side, other}),
                        fixed)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace tokay::structure
