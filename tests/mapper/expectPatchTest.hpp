// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/conservation.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mappingProperties.hpp"

#include <gtest/gtest.h>

namespace tokay::mapper {

/// Constants and linear fields are exact, forces and moments kept, transposes equal.
template <class From, class To>
void expectPatchTest(const From& from, const To& to, const MortarOptions& options = {}) {
    const MortarMapping mapping(from, to, options);
    const Points expected = linearField(to.coordinates());
    const Points mapped = mapping.apply(linearField(from.coordinates()));
    const auto field = [&](const Points& values) { return (mapping.massMatrix() * values).norm(); };
    EXPECT_LT(field(mapped - expected), 1e-12 * field(expected));
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
    expectForceAndMomentConserved(mapping, mapping.massMatrix() * probeForces(to.nValues()),
                                  from.coordinates(), to.coordinates());
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

} // namespace tokay::mapper
