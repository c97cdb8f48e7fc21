// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// Resultant properties of a beam or cable, for its whole width.
struct LineSection {
    double axialStiffness = 0;   ///< [N]
    double bendingStiffness = 0; ///< 0: a cable [N m^2]
    double prestress = 0;        ///< axial force in the reference configuration [N]
    double mass = 0;             ///< per length [kg/m]
    double rotaryInertia = 0;    ///< per length; 0: neglected [kg m]
    double thickness = 0;        ///< [m]
    double width = 1;            ///< across the plane [m]
    double massDamping = 0;      ///< Rayleigh [1/s]
    double stiffnessDamping = 0; ///< Rayleigh [s]

    bool bends() const { return bendingStiffness > 0; }
};

} // namespace tokay::structure
