// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LatestValue.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"
#include "igaStructure/kinematics/shell/egm/DirichletExtension.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"
#include "igaStructure/kinematics/shell/element/ShellNodes.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// Supports of a shell: what they prescribe, how they move, and what they bear.
class ShellSupports {
  public:
    /// All are borrowed.
    /// @throws InputError as shellConstraints() and DirichletExtension
    ShellSupports(const ShellDescription& description, const ShellPatches& patches,
                  const ShellNodes& nodes);

    const ShellConstraints& constraints() const { return constraints_; }
    /// Of supports on trimming curves by EdgeMethod::egm; none: there are none.
    const DirichletExtension* extension() const { return extension_.get(); }

    /// As in StructuralModel.
    bool hasPrescribedMotion() const {
        return !constraints_.trace.isEmpty() || (extension_ && extension_->hasData());
    }
    Eigen::VectorXd prescribed(double time) const;
    bool settle(const Eigen::VectorXd& displacement);
    StructuralModel::SupportShift shift(double time) const;
    bool resistInertia(double massFactor);

    /// Names, edges before points.
    std::vector<std::string> names() const;
    std::vector<SupportLoad> loads(const Eigen::VectorXd& displacement,
                                   const Eigen::VectorXd& reaction, double time) const;

  private:
    const std::vector<EdgeCoupling::Shift>& couplingShifts(double time) const;

    const ShellDescription& description_;
    const ShellNodes& nodes_;
    ShellConstraints constraints_;
    std::unique_ptr<DirichletExtension> extension_;
    mutable LatestValue<std::vector<EdgeCoupling::Shift>> latestShifts_; ///< of couplings
    Eigen::VectorXd lastIterate_; ///< that prescribed motion follows in the iterated form
    int nIterates_ = 0;
};

} // namespace tokay::structure
