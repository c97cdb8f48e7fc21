// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// A material point of a body: parameters on a patch (a curve has no eta), and
/// for a thin body the distance from its axis or middle surface along the
/// normal of the reference configuration [m]; for a solid the third parameter.
struct Location {
    int patch = 0;
    double xi = 0;
    double eta = 0;
    double zeta = 0;
};

} // namespace tokay::structure
