// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/Mapping.hpp"

namespace tokay::mapper {

/// A linear vector field at points.
Points linearField(const Points& x);

/// The work of forces mapped by the transpose is that of mapped values.
void expectTransposesEqual(const Mapping& mapping, int nFrom, int nTo);

/// Sum and moment of forces are kept to 1e-12 of their absolute sum.
void expectForceAndMomentConserved(const Mapping& mapping, const Points& forces, const Points& from,
                                   const Points& to);

} // namespace tokay::mapper
