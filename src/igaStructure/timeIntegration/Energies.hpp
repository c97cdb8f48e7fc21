// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// Energies of a structure [J], per unit depth where its forces are.
struct Energies {
    double kinetic = 0;
    double strain = 0;
    double externalWork = 0; ///< done by external forces since the start
    double dampingWork = 0;  ///< taken by Rayleigh damping since the start
};

} // namespace tokay::structure
