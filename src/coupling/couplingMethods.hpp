// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/CoupledStructure.hpp"
#include "coupling/step/CouplingMethod.hpp"
#include "coupling/step/CouplingOptions.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::coupling {

/// One way to couple: its name in the case file, what it is, its own options, how it is
/// made.
struct CouplingMethodType {
    std::string name;
    std::string meaning;
    SchemaOf<AccelerationOptions> entries;
    /// @throws InputError if options exclude each other; empty: none do
    void (*requireConsistent)(const AccelerationOptions&);
    std::unique_ptr<CouplingMethod> (*make)(const CouplingOptions& options, double tolerance,
                                            CoupledStructure& structure);
};

/// All ways to couple; a new one joins the program here.
const std::vector<CouplingMethodType>& couplingMethods();

/// Schema of all options of the coupling.
const SchemaOf<CouplingOptions>& couplingSchema();

/// @throws InputError that names the option, its value and what is allowed
void requireValid(const CouplingOptions& options);

/// The method that the options name, at the structure's accepted state.
/// @param tolerance  of the fluid; @see ConvergenceCriteria
/// @param structure  is kept by reference
/// @throws InputError if an option or the tolerance is out of its range
std::unique_ptr<CouplingMethod> makeCouplingMethod(const CouplingOptions& options, double tolerance,
                                                   CoupledStructure& structure);

} // namespace tokay::coupling
