// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/UnitNormal.hpp"
#include "igaStructure/kinematics/shell/element/ShellSection.hpp"

namespace tokay::structure {

/// Derivatives of a surface's position or displacement at a point, a column each:
/// by 1, 2, 11, 12, 22. Columns 1 and 2 of a position are the base vectors a1, a2.
using SurfaceDerivatives = Eigen::Matrix<double, 3, 5>;

/// By the components of SurfaceDerivatives, column after column.
using ShellHessian = Eigen::Matrix<double, 15, 15>;

/// A point of a surface.
struct SurfacePoint {
    explicit SurfacePoint(const SurfaceDerivatives& position)
        : derivatives(position), normal(position.col(0), position.col(1)) {}

    FundamentalForms forms() const;

    SurfaceDerivatives derivatives;
    UnitNormal normal;
};

/// Strains of SectionResponse: E = (a . a - A . A) / 2, k = B - b, or their
/// linear part.
/// Source: Kiendl, Bletzinger, Linhard & Wuechner 2009, equations 17 and 18
Vector6d shellStrain(const SurfacePoint& reference, const SurfaceDerivatives& displacement,
                     Strains kind);

/// Change of the unit normal, without the loss of digits of a difference; or its
/// linear part.
Eigen::Vector3d normalChange(const SurfacePoint& reference, const SurfaceDerivatives& displacement,
                             Strains kind);

/// Derivative by the components of the position of the work of resultants that
/// are constant.
SurfaceDerivatives shellForce(const SurfacePoint& current, const Vector6d& resultants);

/// Second derivative of the strain energy by the components of the position.
/// @param tangent     derivative of the resultants by the strains
/// @param resultants  zero for linear strains
ShellHessian shellStiffness(const SurfacePoint& current, const Matrix6d& tangent,
                            const Vector6d& resultants);

} // namespace tokay::structure
