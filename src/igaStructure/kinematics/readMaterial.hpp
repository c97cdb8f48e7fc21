// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/Field.hpp"

#include <string>

namespace tokay::structure {

class CaseSection;

/// The material of a shell, a membrane or a solid.
ElasticMaterial readMaterial(const CaseSection& file);

/// Formulas of place and time for three components, or for a number.
VectorField readVectorField(const CaseSection& section, const std::string& name);
ScalarField readScalarField(const CaseSection& section, const std::string& name);

} // namespace tokay::structure
