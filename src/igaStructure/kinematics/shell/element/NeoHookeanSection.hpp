// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/shell/element/ShellSection.hpp"

namespace tokay::structure {

/// Neo-Hookean material with energy mu/2 (tr C - 3) - mu ln J + lambda/2 ln^2 J, or
/// incompressible, integrated over the thickness; the stretch across it is such
/// that there is no stress. Metrics are linear in the distance from the middle
/// surface, and the volume element is that of the middle surface.
/// Source: Kiendl, Hsu, Wu & Reali 2015
class NeoHookeanSection : public ShellSection {
  public:
    /// @param lambda  infinite: incompressible [Pa]
    NeoHookeanSection(double mu, double lambda, double thickness);

    /// @throws SolverError if the section is crushed or folded through itself
    SectionResponse response(const FundamentalForms& reference,
                             const Vector6d& strains) const override;

  private:
    struct LayerResponse {
        Eigen::Vector3d stress;
        Eigen::Matrix3d tangent;
        double energy;
    };
    LayerResponse layer(const Eigen::Vector3d& reference, const Eigen::Vector3d& current) const;
    double squaredThicknessStretch(double logAreaStretch) const;

    double mu_, lambda_, thickness_;
};

} // namespace tokay::structure
