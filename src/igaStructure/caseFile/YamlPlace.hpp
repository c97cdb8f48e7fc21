// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <yaml-cpp/node/node.h>

#include <string>

namespace tokay::structure {

/// A node of a YAML file and how to speak of it.
struct YamlPlace {
    std::string file;
    YAML::Node node;
    std::string tablePath; ///< of its entry in the table: "loads[].edge"
    std::string path;      ///< as the user sees it: "loads[0].edge"

    /// "file:line:column: path: message"; lines and columns count from 1.
    InputError error(const std::string& message) const;

    /// As error, at a mark of the caller's.
    InputError errorAt(const YAML::Mark& mark, const std::string& message) const;

    YamlPlace child(const std::string& name) const;
    YamlPlace item(std::size_t index) const;
};

} // namespace tokay::structure
