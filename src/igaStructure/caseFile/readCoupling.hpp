#pragma once

#include "igaStructure/caseFile/Case.hpp"

namespace tokay::structure {

class CaseSection;

/// Reads `coupling` of the case file.
/// @throws InputError  also for an option that the chosen acceleration does not have
Coupling readCoupling(const CaseSection& section);

/// The name of an acceleration in the case file.
std::string nameOf(coupling::Acceleration acceleration);

} // namespace tokay::structure
