// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// Entries of `newton` in the case file.
struct NewtonOptions {
    double tolerance = 1e-8; ///< out-of-balance force over the largest force in balance
    int maximumIterations = 25;
    bool lineSearch = true;
    /// A factored tangent is kept while an iteration leaves at most this share of
    /// the residual; 0: a new one each iteration.
    double reuseContraction = 0;
};

} // namespace tokay::structure
