// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/JsonObject.hpp"

#include <string>

namespace tokay::mapper {

/// Matching, conservation and cost of a mapping. Errors are
/// relative; a moment error above rounding is the moment of forces over gaps.
struct MappingReport {
    std::string method;
    /// Destination points, or quadrature points on the destination.
    int nPoints = 0;
    /// Points with no projection within the gap limit.
    int nUnmatched = 0;
    /// Points with two projections equally near.
    int nAmbiguous = 0;
    /// Fraction of the destination that is matched, 0 to 1.
    double coverage = 0;
    /// Largest distance of a point to its projection [m], and where it is.
    double largestGap = 0;
    int worstPoint = -1;
    /// The largest gap over the size of the interface.
    double relativeGap = 0;
    /// Largest deviation of a row sum from 1: the error of a constant.
    double rowSumError = 0;
    /// Error of the sum of forces mapped by the transpose.
    double forceSumError = 0;
    /// Error of the sum of moments mapped by the transpose.
    double momentError = 0;
    /// Destination values that lie on the interface and get nothing.
    int nUncovered = 0;
    /// Size and rank of the matrix that was inverted, and its condition on the
    /// range; 0 if there is none.
    int nInverted = 0;
    int rank = 0;
    double condition = 0;
    /// Rule for values that a singular matrix leaves open; empty if none.
    std::string regularisation;
    /// Wall-clock time to build the mapping [s].
    double seconds = 0;
    /// Memory of the matrices [byte].
    double bytes = 0;

    /// Report of a few lines for a person.
    std::string text() const;

    /// Report for programs, names with their units.
    JsonObject json() const;
};

} // namespace tokay::mapper
