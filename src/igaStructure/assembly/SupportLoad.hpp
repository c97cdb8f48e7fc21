// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/Points.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace tokay::structure {

/// Resultant of the forces by which a support acts on a body.
struct SupportLoad {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< [N]
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< about the origin [N m]

    void add(const Eigen::Vector3d& position, const Eigen::Vector3d& ownForce) {
        force += ownForce;
        moment += position.cross(ownForce);
    }
};

/// Number of the support that holds each unknown, the first of several; -1: none.
using SupportOwners = std::vector<int>;

/// Lets a support own what it fixes and none before it does.
inline void addOwner(SupportOwners& owners, const std::vector<bool>& fixed, int support) {
    owners.resize(fixed.size(), -1);
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        if (fixed[k] && owners[k] < 0) {
            owners[k] = support;
        }
    }
}

/// Adds forces on unknowns to the loads of the supports that own these.
/// @param positions    of the nodes [m]
/// @param nComponents  unknowns a node, 2 or 3
inline void addForces(const SupportOwners& owners, const geometry::Points& positions,
                      int nComponents, const Eigen::VectorXd& forces,
                      std::vector<SupportLoad>& loads) {
    for (std::size_t k = 0; k < owners.size(); ++k) {
        if (owners[k] >= 0) {
            const auto unknown = static_cast<int>(k);
            loads[owners[k]].add(positions.row(unknown / nComponents),
                                 forces[unknown] * Eigen::Vector3d::Unit(unknown % nComponents));
        }
    }
}

/// Positions of nodes that have moved [m].
inline geometry::Points moved(geometry::Points positions, int nComponents,
                              const Eigen::VectorXd& displacement) {
    for (Eigen::Index k = 0; k < displacement.size(); ++k) {
        positions(k / nComponents, k % nComponents) += displacement[k];
    }
    return positions;
}

} // namespace tokay::structure
