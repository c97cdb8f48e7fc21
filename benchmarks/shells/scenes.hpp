// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/Shell.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tokay::structure {

/// A published shell with what is looked at.
struct Scene {
    std::string name;
    ShellDescription description;
    /// The quantity that is compared, from the displacement.
    std::function<double(const Shell&, const Eigen::VectorXd&)> quantity;
    double reference;
    double limit; ///< relative, within which it shall be
};

/// Linear shells: reference/shellsLinear.csv.
/// @param isQuick  coarser meshes
std::vector<Scene> linearScenes(bool isQuick);

/// The roof of Scordelis and Lo whole, cut out of a larger patch, and of three patches
/// that do not match, with about 8 n elements a side.
std::vector<Scene> roofScenes(int n);

/// Cantilever with a dead shear force or an end moment that grows with time from 0
/// to 1, E 1.2e6, thickness 0.1, width 1.
ShellDescription shearedCantilever();
ShellDescription rolledCantilever();

/// Octant of a sphere of radius 10 and thickness 0.1, neo-Hookean with mu 4.225e5,
/// under a pressure.
ShellDescription balloon(const ScalarField& pressure);
/// The same as a membrane of two patches that do not match, with n by n elements of
/// degree 3 on the one and n + 1 by n + 3 on the other, which meet along a meridian.
ShellDescription balloonHalves(const ScalarField& pressure, int n);
/// Stretch of balloonHalves at the point of the joint, on either side of it, that is
/// farthest from a stretch.
double worstStretchOfJoint(const Shell& shell, const Eigen::VectorXd& displacement,
                           double expected);
/// Pressure at a stretch, by the formula.
double balloonPressure(double stretch);

/// The tip of a patch's displacement at parameters.
Eigen::Vector3d displacementAt(const Shell& shell, double xi, double eta,
                               const Eigen::VectorXd& displacement);

} // namespace tokay::structure
