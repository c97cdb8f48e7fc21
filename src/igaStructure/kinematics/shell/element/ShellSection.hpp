// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/UnitNormal.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// Covariant components (11, 22, 12) of the first and second fundamental form of a
/// reference surface.
struct FundamentalForms {
    Eigen::Vector3d metric;
    Eigen::Vector3d curvature;
};

/// Components (11, 22, 12) of the inverse of a metric.
Eigen::Vector3d contravariant(const Eigen::Vector3d& metric);

/// Resultants of a shell section at strains of its middle surface. Strains are
/// (E11, E22, 2 E12, k11, k22, 2 k12), membrane strains and curvature changes; the
/// resultants are the contravariant (n11, n22, n12, m11, m22, m12), work-conjugate
/// per reference area.
struct SectionResponse {
    Vector6d resultants = Vector6d::Zero();
    Matrix6d tangent = Matrix6d::Zero();
    double energy = 0; ///< per reference area [J/m^2]
};

/// A material integrated over the thickness of a shell or membrane, with no
/// stress across it.
class ShellSection {
  public:
    virtual ~ShellSection() = default;

    /// @throws SolverError if the thickness has no equilibrium at these strains
    virtual SectionResponse response(const FundamentalForms& reference,
                                     const Vector6d& strains) const = 0;
};

/// St. Venant-Kirchhoff material: resultants linear in the strains.
class LinearSection : public ShellSection {
  public:
    LinearSection(const ElasticMaterial& material, double thickness);

    SectionResponse response(const FundamentalForms& reference,
                             const Vector6d& strains) const override;

  private:
    double poissonsRatio_;
    double membraneStiffness_; ///< E t / (1 - nu^2) [N/m]
    double bendingStiffness_;  ///< E t^3 / 12 / (1 - nu^2) [N m]
};

} // namespace tokay::structure
