// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/egm/ExtendedElements.hpp"
#include "igaStructure/kinematics/shell/egm/ExtensionFunctional.hpp"

namespace tokay::structure {

/// What makes control values of a bent patch of degree 3 go on from the others:
///   gamma sum_e h^6 int (change of the jump of d^3 u from one face of e to the other)^2.
///
/// Of degree 3 the fourth derivative, which the load on a plate decides, is in the jumps of the
/// third one (StrongForm). To ask that they vanish, as for membranes, denies the load: the
/// deflection of a clamped disc of 36 elements a side is off by 4e-2, and by 7e-5 if they only
/// shall not change.
class JumpChangeTerm {
  public:
    /// All is borrowed.
    /// @param face   of the shell
    /// @param axis   that the faces lie across: 0, xi, or 1, eta
    /// @param gamma  of EgmOptions
    JumpChangeTerm(const ShellPatch& patch, int face, int axis, const ExtendedElements& elements,
                   double gamma)
        : patch_(patch), face_(face), axis_(axis), elements_(elements), gamma_(gamma) {}

    void add(ExtensionFunctional& functional) const;

  private:
    void addElement(int element, ExtensionFunctional& functional) const;

    const ShellPatch& patch_;
    int face_, axis_;
    const ExtendedElements& elements_;
    double gamma_;
};

} // namespace tokay::structure
