#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/MappingReport.hpp"
#include "mapper/SparseMatrix.hpp"

namespace tokay::mapper {

/// Measures what a consistent matrix (nTo x nFrom) and its transpose keep and
/// enters it in the report: constants, and the sum and the moment of a set of
/// forces on the destination.
/// @param from  coordinates of the source's values, nFrom x 3 [m]
/// @param to    coordinates of the destination's values, nTo x 3 [m]
void measureConservation(const SparseMatrix& matrix, const Points& from, const Points& to,
                         MappingReport& report);

} // namespace tokay::mapper
