// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/egm/ExtendedElements.hpp"
#include "igaStructure/kinematics/shell/egm/ExtensionFunctional.hpp"

#include <map>
#include <vector>

namespace tokay::structure {

/// The gradient term of the extended gradient method: h int (d_n u - g)^2 over whole cut
/// elements, n being the mean direction across the curve in each, and g the derivative along
/// n in uncut elements nearby, continued by moving least squares.
/// Source: Camarotti's report, algorithm 2; Lancaster & Salkauskas 1981 (moving least squares)
class GradientTerm {
  public:
    /// All is borrowed.
    /// @param face  of the shell
    GradientTerm(const ShellPatch& patch, int face, const ExtendedElements& elements);

    void add(ExtensionFunctional& functional);

  private:
    struct Sample {
        PatchLocation at;
        Eigen::Vector2d place; ///< in elements
    };
    std::map<int, Eigen::Vector3d> directions() const;
    void addElement(int element, const Eigen::Vector3d& direction, ExtensionFunctional& functional);
    std::vector<const Sample*> samplesNear(int element);
    const std::vector<Sample>& samplesIn(int element);
    Eigen::Vector2d inElements(const geometry::Parameters& at, int element) const;

    const ShellPatch& patch_;
    int face_;
    const ExtendedElements& elements_;
    int degree_;
    std::map<int, std::vector<Sample>> samples_; ///< of elements that were asked for
};

} // namespace tokay::structure
