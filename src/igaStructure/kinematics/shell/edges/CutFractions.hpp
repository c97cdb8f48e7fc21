// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

#include <vector>

namespace tokay::structure {

/// Fractions of the elements of a patch that trimming leaves, and for each sliver the
/// element that can replace it.
class CutFractions {
  public:
    /// Elements with less than this fraction are slivers.
    static constexpr double least = 0.2;

    explicit CutFractions(const ShellPatch& patch);

    /// Fraction of the parameter area that is left; 0 to 1.
    double of(int element) const { return fractions_[element]; }
    bool isSliver(int element) const { return fractions_[element] < least; }

    /// The element itself, or the best of its neighbours if it is a sliver; the
    /// sliver if none is better. Across a kink of the surface or of its parameters none
    /// is, since what is continued there is no rigid motion of the sliver.
    int standIn(int element) const;

  private:
    const ShellPatch* patch_;
    std::vector<double> fractions_;
};

} // namespace tokay::structure
