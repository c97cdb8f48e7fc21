// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Body.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Forces and moments of the supports of a body, as columns of a table.
class ReactionColumns {
  public:
    /// @param body   is kept by reference
    /// @param about  point of the moments [m]; none: no columns
    ReactionColumns(const Body& body, const std::optional<Coordinates>& about)
        : body_(body), about_(about) {}

    bool isEmpty() const { return names().empty(); }

    /// "left.fx[N]", …, "left.mz[N.m]" for each support; a plane scene has fx, fy and mz.
    std::vector<std::string> names() const;

    std::vector<double> values(const MotionState& state) const;

  private:
    const Body& body_;
    std::optional<Coordinates> about_;
};

} // namespace tokay::structure
