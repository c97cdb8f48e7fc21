// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"

#include <array>
#include <vector>

namespace tokay::structure {

/// A point of a supported trimming curve, seen from an element that has body there.
struct TracePoint {
    const TrimmedSupport* support;
    EdgePoint on;
    int element;
};

/// Which elements the supported trimming curves cut, and which unknowns hence do not
/// follow from equilibrium: those of functions whose support meets such an element (D).
class ExtendedElements {
  public:
    using Components = std::array<bool, 3>;

    /// @param fixed  unknowns that other supports hold, and those without body
    /// @throws InputError if a curve lies in no element, is smaller than one, or leaves no
    ///         functions to extend from
    ExtendedElements(const ShellDescription& description, const ShellPatches& patches,
                     const std::vector<TrimmedSupport>& supports, const std::vector<bool>& fixed);

    const std::vector<TracePoint>& trace() const { return trace_; }
    /// Components that are held on a curve that cuts the element.
    const Components& cut(int face, int element) const { return cut_[face][element]; }
    /// Unknowns of D, ascending.
    const std::vector<int>& dependents() const { return dependents_; }
    /// Components in which a function of the element belongs to D.
    Components dependsIn(int face, int element) const;
    bool hasBody(int face, int element) const;
    const std::vector<int>& nodes(int face, int element) const { return nodes_[face][element]; }

  private:
    void addTrace(const TrimmedSupport& support);
    void markDependents(const std::vector<bool>& fixed);
    void requireLargeLoops(const TrimmedSupport& support) const;
    void requireInterior(const std::vector<TrimmedSupport>& supports,
                         const std::vector<bool>& fixed) const;

    const ShellDescription& description_;
    const ShellPatches& patches_;
    std::vector<TracePoint> trace_;
    std::vector<std::vector<Components>> cut_;         ///< [face][element]
    std::vector<std::vector<std::vector<int>>> nodes_; ///< the same
    std::vector<bool> isDependent_;
    std::vector<int> dependents_;
};

} // namespace tokay::structure
