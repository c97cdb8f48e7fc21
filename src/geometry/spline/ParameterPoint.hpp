// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::geometry {

/// A quadrature point in the parameter space of a patch.
struct ParameterPoint {
    double xi, eta;
    /// Of the parameter area, without the surface's Jacobian.
    double weight;
};

} // namespace tokay::geometry
