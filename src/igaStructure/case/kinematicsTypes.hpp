// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/caseFile/readOptions.hpp"
#include "igaStructure/kinematics/CaseContext.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// Entries of a case file that describe a body, of the type that its kinematics has.
class BodyEntries {
  public:
    virtual ~BodyEntries() = default;
    virtual void* entries() = 0;
    virtual Coupling& coupling() = 0;
    /// @throws InputError for entries that do not fit each other
    virtual StructureCase make(const CaseContext& context) const = 0;
};

/// A kinematics: its name in the case file, its entries, and how it is made of them.
struct KinematicsType {
    std::string name;
    std::string meaning;
    const Schema* schema;
    std::function<std::unique_ptr<BodyEntries>()> makeEntries;
    bool bendsThinly = false; ///< residuals grow before they fall: no line search by default
};

/// All kinematics; a new one joins the program here and in makeBody.
const std::vector<KinematicsType>& kinematicsTypes();

} // namespace tokay::structure
