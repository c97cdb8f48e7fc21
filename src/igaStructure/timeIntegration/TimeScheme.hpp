// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// Coefficients of an implicit one-step scheme of the generalised-alpha family,
///
///   M a(1-alphaM) + C v(1-alphaF) + internal(d(1-alphaF)) = external(1-alphaF),
///   d1 = d0 + dt v0 + dt^2 ((1/2 - beta) a0 + beta a1),  v1 = v0 + dt ((1 - gamma) a0 + gamma a1),
///
/// where x(1-alpha) = (1 - alpha) x1 + alpha x0, 0 and 1 being the start and end of a step.
struct TimeScheme {
    double alphaM = 0;
    double alphaF = 0;
    double beta = 0.25;
    double gamma = 0.5;
    bool dynamic = true; ///< false: no inertia, no damping: internal(d1) = external(1)

    /// Second order, least dissipation of low frequencies for the wanted
    /// spectral radius at infinite frequency, 0 to 1.
    /// Source: Chung & Hulbert 1993, equation 25
    static TimeScheme generalisedAlpha(double spectralRadius) {
        TimeScheme scheme;
        scheme.alphaM = (2 * spectralRadius - 1) / (spectralRadius + 1);
        scheme.alphaF = spectralRadius / (spectralRadius + 1);
        const double difference = scheme.alphaM - scheme.alphaF;
        scheme.gamma = 0.5 - difference;
        scheme.beta = 0.25 * (1 - difference) * (1 - difference);
        return scheme;
    }

    static TimeScheme newmark(double beta, double gamma) { return {0, 0, beta, gamma, true}; }

    static TimeScheme quasiStatic() { return {0, 0, 0.25, 0.5, false}; }
};

} // namespace tokay::structure
