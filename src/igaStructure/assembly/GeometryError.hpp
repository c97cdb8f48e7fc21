// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

namespace tokay::structure {

/// A geometry that folds over, or has no extent somewhere; who knows the case file
/// adds where the geometry stands in it.
class GeometryError : public InputError {
  public:
    using InputError::InputError;
};

} // namespace tokay::structure
