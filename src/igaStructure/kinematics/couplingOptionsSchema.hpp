// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "coupling/step/CouplingOptions.hpp"

namespace tokay::structure {

/// Entries of `coupling` that the coupling methods use.
const SchemaOf<coupling::CouplingOptions>& couplingOptionsSchema();

} // namespace tokay::structure
