// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

#include <set>
#include <string>
#include <utility>

namespace tokay::structure {

/// Writes the tables of entries of the manual (doc/caseFile.md), in Markdown.
class SchemaTables {
  public:
    /// Table of all entries of a map and of the maps inside it; below it one for each
    /// alternative that brings entries of its own. A map that several paths or calls
    /// share is written once.
    /// @param path  of the map; empty: the file
    std::string table(const std::string& path, const Schema& schema);

  private:
    std::string rows(const std::string& path, const Schema& schema, void* options);
    std::string row(const std::string& path, const Entry& entry, void* options);

    std::set<std::pair<std::string, const Schema*>> written_;
    std::string below_; ///< tables of alternatives
};

/// Values in effect, "maxRank 200, filter qr2": what a log says of options. Options
/// inside them have a line each.
std::string describeOptions(const Schema& schema, void* options);

} // namespace tokay::structure
