// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CoupledStructure.hpp"
#include "coupling/step/CouplingMethod.hpp"
#include "coupling/step/CouplingOptions.hpp"

#include <memory>
#include <vector>

namespace tokay::coupling {

/// One way to couple: its name in the case file, what it is, how it is made.
struct CouplingMethodType {
    Acceleration acceleration;
    const char* name;
    const char* description;
    std::unique_ptr<CouplingMethod> (*make)(const CouplingOptions& options, double tolerance,
                                            CoupledStructure& structure);
};

/// All ways to couple; a new one joins the program here.
const std::vector<CouplingMethodType>& couplingMethods();

/// The method that the options name, at the structure's accepted state.
/// @param tolerance  of the fluid; @see ConvergenceCriteria
/// @param structure  is kept by reference
/// @throws InputError if an option or the tolerance is out of its range
std::unique_ptr<CouplingMethod> makeCouplingMethod(const CouplingOptions& options, double tolerance,
                                                   CoupledStructure& structure);

} // namespace tokay::coupling
