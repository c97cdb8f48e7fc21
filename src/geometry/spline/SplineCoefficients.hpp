// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/KnotVector.hpp"

namespace tokay::geometry {

/// A spline of any number of components, c(xi) = sum of N_i(xi) row i: what
/// refinement works on. With the identity as rows it gives the refinement operator.
struct SplineCoefficients {
    KnotVector knots;
    /// nBasis x m
    Eigen::MatrixXd rows;
};

/// Spline with knots inserted (ascending, repeated as often as wanted).
SplineCoefficients insertKnots(const SplineCoefficients& spline, const std::vector<double>& knots);

/// Spline with knots removed (ascending, repeated as often as wanted).
/// @param tolerance  by how far coefficients may be off, relative to their extent
/// @throws InputError if a knot is not there so often, or the spline is not smooth
///         enough there
SplineCoefficients removeKnots(const SplineCoefficients& spline, const std::vector<double>& knots,
                               double tolerance);

/// Spline with its degree raised by one.
SplineCoefficients elevateDegree(const SplineCoefficients& spline);

} // namespace tokay::geometry
