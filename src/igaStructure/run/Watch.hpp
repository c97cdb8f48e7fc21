// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Body.hpp"

namespace tokay::structure {

/// The watch points of a case, found on the body.
class Watch {
  public:
    /// @param body  is kept by reference
    /// @throws InputError for a point that is not on the body
    Watch(const Body& body, const std::vector<WatchPoint>& points);

    bool isEmpty() const { return names_.empty(); }

    /// "tip.x[m]", "tip.y[m]", …
    std::vector<std::string> columns() const;

    /// Displacements in the order of the columns [m].
    std::vector<double> values(const Eigen::VectorXd& displacement) const;

    /// "tip (0.0123, -0.0001) m" of the first point, for the log; empty if none.
    std::string text(const Eigen::VectorXd& displacement) const;

  private:
    const Body& body_;
    std::vector<std::string> names_;
    std::vector<Location> locations_;
};

} // namespace tokay::structure
