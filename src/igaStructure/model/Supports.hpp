#pragma once

#include "geometry/NurbsSurface.hpp"

#include <array>
#include <string>
#include <vector>

namespace tokay::structure {

/// Displacement components of an edge that are zero.
struct Support {
    geometry::Edge edge;
    std::array<bool, 2> fixed = {false, false};
};

/// Unknowns of a plane patch that supports fix. An open knot vector makes the
/// patch's edge depend on the edge's control points only, so fixing these is exact.
/// @return  2 nControlPoints, component c of control point k is 2 k + c
std::vector<bool> fixedUnknowns(const geometry::NurbsSurface& surface,
                                const std::vector<Support>& supports);

/// Rigid motions of a plane body that are possible though unknowns are fixed:
/// "translation along x", "translation along y", "rotation".
std::vector<std::string> freeRigidMotions(const geometry::NurbsSurface& surface,
                                          const std::vector<bool>& fixed);

/// The same from the rigid motions at what is held, one row each, lengths relative
/// to the body's size. Columns: along x and y and rotation of a plane body; along
/// x, y and z and rotation about each of a body in space.
/// @param nMotions  that are to be held: a straight line's turning about itself is none
std::vector<std::string> freeRigidMotions(const Eigen::MatrixXd& heldMotions, int nMotions);

} // namespace tokay::structure
