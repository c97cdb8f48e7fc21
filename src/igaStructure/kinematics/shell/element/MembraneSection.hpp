// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellSection.hpp"

#include <memory>

namespace tokay::structure {

/// The membrane part of another section, with prestress and without bending.
class MembraneSection : public ShellSection {
  public:
    /// @param prestress  times thickness: 11, 22, 12 in the frame whose axis 1 is
    ///                   along the first parameter line [N/m]
    MembraneSection(std::shared_ptr<const ShellSection> whole, const Eigen::Vector3d& prestress)
        : whole_(std::move(whole)), prestress_(prestress) {}

    SectionResponse response(const FundamentalForms& reference,
                             const Vector6d& strains) const override;

  private:
    std::shared_ptr<const ShellSection> whole_;
    Eigen::Vector3d prestress_;
};

} // namespace tokay::structure
