#pragma once

namespace tokay::structure {

/// Entries of `newton` in the case file.
struct NewtonOptions {
    double tolerance = 1e-8; ///< out-of-balance force over the largest force in balance
    int maximumIterations = 25;
    bool lineSearch = true;
};

} // namespace tokay::structure
