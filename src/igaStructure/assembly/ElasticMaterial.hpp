// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::structure {

/// Small strains and rotations, or Green-Lagrange strains.
enum class Strains { linear, nonlinear };

enum class MaterialLaw {
    stVenantKirchhoff,
    neoHookean,
    incompressibleNeoHookean ///< Poisson's ratio 0.5
};

/// An isotropic elastic material.
struct ElasticMaterial {
    double youngsModulus = 0;    ///< at small strains [Pa]
    double poissonsRatio = 0;    ///< at small strains
    double density = 0;          ///< reference configuration [kg/m^3]
    double massDamping = 0;      ///< Rayleigh [1/s]
    double stiffnessDamping = 0; ///< Rayleigh [s]
    MaterialLaw law = MaterialLaw::stVenantKirchhoff;

    /// Lamé's constants at small strains [Pa]; lambda of an incompressible material is
    /// infinite.
    double lambda() const;
    double mu() const;

    /// Stress per strain of a strip that cannot strain sideways and is free of stress
    /// across its thickness, E / (1 - nu^2) [Pa].
    double planeStressModulus() const;

    /// Law and constants, for the log.
    std::string description() const;
};

} // namespace tokay::structure
