// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/NeoHookeanSection.hpp"

#include "common/errors.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"

#include <cmath>
#include <limits>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int nLayers = 4; // Gauss points over the thickness

double determinant(const Vector3d& metric) {
    return metric[0] * metric[1] - metric[2] * metric[2];
}

// g^ab g^cd, and g^ac g^bd + g^ad g^bc, as matrices of (11, 22, 12).
Matrix3d outer(const Vector3d& g) {
    return g * g.transpose();
}
Matrix3d crossed(const Vector3d& g) {
    Matrix3d C;
    C(0, 0) = 2 * g[0] * g[0];
    C(1, 1) = 2 * g[1] * g[1];
    C(2, 2) = g[0] * g[1] + g[2] * g[2];
    C(0, 1) = C(1, 0) = 2 * g[2] * g[2];
    C(0, 2) = C(2, 0) = 2 * g[0] * g[2];
    C(1, 2) = C(2, 1) = 2 * g[1] * g[2];
    return C;
}

} // namespace

NeoHookeanSection::NeoHookeanSection(double mu, double lambda, double thickness)
    : mu_(mu), lambda_(lambda), thickness_(thickness) {}

// C33 with mu (C33 - 1) + lambda ln J = 0: in x = ln C33 a convex function that
// rises, so Newton's method comes from above.
double NeoHookeanSection::squaredThicknessStretch(double logAreaStretch) const {
    if (std::isinf(lambda_)) {
        return std::exp(-2 * logAreaStretch);
    }
    double x = std::max(0.0, -2 * logAreaStretch);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double value = mu_ * std::expm1(x) + lambda_ * (logAreaStretch + 0.5 * x);
        const double step = value / (mu_ * std::exp(x) + 0.5 * lambda_);
        x -= step;
        if (std::abs(step) <= 4 * std::numeric_limits<double>::epsilon() * (1 + std::abs(x))) {
            break;
        }
    }
    return std::exp(x);
}

NeoHookeanSection::LayerResponse NeoHookeanSection::layer(const Vector3d& reference,
                                                          const Vector3d& current) const {
    const double areaRatio = determinant(current) / determinant(reference);
    if (!(current[0] > 0 && areaRatio > 0)) {
        throw SolverError("the section of a shell is crushed, or bent so much that its inner side "
                          "has no length; use smaller steps");
    }
    const Vector3d G = contravariant(reference);
    const Vector3d g = contravariant(current);
    const double logArea = 0.5 * std::log(areaRatio);
    const double C33 = squaredThicknessStretch(logArea);
    const bool incompressible = std::isinf(lambda_);
    const double coupling = incompressible ? 2 : lambda_ / (mu_ * C33 + 0.5 * lambda_);
    const double logVolume = incompressible ? 0 : logArea + 0.5 * std::log(C33);
    const double trace = G[0] * current[0] + G[1] * current[1] + 2 * G[2] * current[2] + C33;

    LayerResponse response;
    response.stress = mu_ * (G - C33 * g);
    response.tangent = mu_ * C33 * (coupling * outer(g) + crossed(g));
    response.energy = 0.5 * mu_ * (trace - 3) - mu_ * logVolume;
    if (!incompressible) {
        response.energy += 0.5 * lambda_ * logVolume * logVolume;
    }
    return response;
}

SectionResponse NeoHookeanSection::response(const FundamentalForms& reference,
                                            const Vector6d& strains) const {
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(nLayers);
    // Shear strains are doubled, components of the metric are not.
    const Vector3d once(1, 1, 0.5);
    const Vector3d membrane = 2 * strains.head<3>().cwiseProduct(once);
    const Vector3d bending = 2 * strains.tail<3>().cwiseProduct(once);
    SectionResponse response;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const double zeta = thickness_ * (rule.points[k] - 0.5);
        const double weight = thickness_ * rule.weights[k];
        const Vector3d G = reference.metric - 2 * zeta * reference.curvature;
        const LayerResponse at = layer(G, G + membrane + zeta * bending);
        response.energy += weight * at.energy;
        response.resultants.head<3>() += weight * at.stress;
        response.resultants.tail<3>() += weight * zeta * at.stress;
        response.tangent.topLeftCorner<3, 3>() += weight * at.tangent;
        response.tangent.topRightCorner<3, 3>() += weight * zeta * at.tangent;
        response.tangent.bottomRightCorner<3, 3>() += weight * zeta * zeta * at.tangent;
    }
    response.tangent.bottomLeftCorner<3, 3>() = response.tangent.topRightCorner<3, 3>().transpose();
    return response;
}

} // namespace tokay::structure
