// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

enum class MaterialLaw {
    stVenantKirchhoff,
    neoHookean,
    incompressibleNeoHookean ///< of Poisson's ratio 0.5
};

/// Material of a body in space: a shell, a membrane or a solid.
struct ElasticMaterial {
    double youngsModulus = 0;    ///< at small strains [Pa]
    double poissonsRatio = 0;    ///< at small strains
    double density = 0;          ///< reference configuration [kg/m^3]
    double massDamping = 0;      ///< Rayleigh [1/s]
    double stiffnessDamping = 0; ///< Rayleigh [s]
    MaterialLaw law = MaterialLaw::stVenantKirchhoff;
};

} // namespace tokay::structure
