// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

namespace tokay::structure {

/// Entries of `newton` in the case file.
struct NewtonOptions {
    double tolerance = 1e-8;
    int maxIterations = 25;
    bool lineSearch = true;
    double reuseContraction = 0;
    bool mixedStresses = true;

    static const SchemaOf<NewtonOptions>& schema() {
        static const SchemaOf<NewtonOptions> schema = {
            {"tolerance", &NewtonOptions::tolerance, "(0, 1)", "",
             "Out-of-balance force relative to the largest of the internal, inertia and external "
             "forces."},
            {"maxIterations", &NewtonOptions::maxIterations, "[1, 1000]", "",
             "Maximum number of iterations; beyond it, the time step has failed."},
            {"lineSearch", &NewtonOptions::lineSearch,
             "Whether an update is shortened that does not reduce the residual along its own "
             "direction, or inverts the body.",
             otherwise("`no` for a shell or beam, whose residual grows before it falls, else "
                       "`yes`")},
            {"reuseContraction", &NewtonOptions::reuseContraction, "[0, 1)", "",
             "Modified Newton: a factored tangent is reused, over iterations and time steps, while "
             "each iteration reduces the residual to at most this fraction; never beyond a saved "
             "or rejected step. 0: a new tangent in each iteration.",
             otherwise("`0.1`; with scheme static `0`, where each tangent shows whether the "
                       "structure buckles")},
            {"mixedStresses", &NewtonOptions::mixedStresses,
             "Shells and beams with nonlinear strains: a tangent takes the stresses that the last "
             "iteration predicted, not those of its displacement (mixed integration point method, "
             "Magisano et al. 2017): the same solution in fewer iterations, the thinner the body "
             "the fewer. A step that fails is solved once more by exact tangents."}};
        return schema;
    }
};

} // namespace tokay::structure
