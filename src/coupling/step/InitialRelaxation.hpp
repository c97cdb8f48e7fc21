// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

namespace tokay::coupling {

/// Option of methods that must move once before they can learn.
struct InitialRelaxation {
    double initialRelaxation = 0.1;

    static const SchemaOf<InitialRelaxation>& schema() {
        static const SchemaOf<InitialRelaxation> schema = {
            {"initialRelaxation", &InitialRelaxation::initialRelaxation, "(0, 2]", "",
             "Relaxation factor of a step about which nothing is known yet."}};
        return schema;
    }
};

} // namespace tokay::coupling
