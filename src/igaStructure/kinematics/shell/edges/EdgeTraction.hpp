// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"

namespace tokay::structure {

/// Tractions of a linear shell or membrane on an edge, as linear functions of the
/// displacement of an element's nodes: integrating the work of its stresses by parts
/// leaves, per length of the edge, force . v + twist . dv/dt - moment a3 . dv/dc,
/// t being the edge's tangent and c its outward conormal.
struct EdgeTraction {
    /// @param place    on the edge
    /// @param element  whose functions are taken, beyond its rim too
    /// @param bending  false: a membrane
    EdgeTraction(const PatchLocation& place, int element, bool bending);

    std::vector<int> nodes;
    Eigen::MatrixXd force;     ///< 3 rows [N/m]; component c of node k is column 3 k + c
    Eigen::MatrixXd twist;     ///< 3 rows, along the normal [N]
    Eigen::RowVectorXd moment; ///< [N]
};

} // namespace tokay::structure
