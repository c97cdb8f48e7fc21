// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LocatedNode.hpp"
#include "common/Schema.hpp"

#include <string>
#include <vector>

namespace tokay::structure {

/// A choice made elsewhere in the file that decides which entries a map may have.
struct MadeChoice {
    std::string name;                  ///< "shell"; empty: none
    std::vector<const Schema*> others; ///< of the same map after another choice
};

/// Fills options from a map of a YAML file: known entries only, each at most once,
/// required ones given, of the right kind, length and range; words from their choices.
/// Entries that are not given keep their value.
/// @throws InputError for the first mistake: file, line, column, entry, what is allowed
void readOptions(const LocatedNode& map, const Schema& schema, void* options,
                 const MadeChoice& choice = {});

template <class Options>
void readOptions(const LocatedNode& map, Options& options) {
    readOptions(map, Options::schema(), &options);
}

/// Root of a YAML text.
/// @param file  for messages
/// @throws InputError if it is not YAML
LocatedNode parseYaml(const std::string& text, const std::string& file);

/// Root of a YAML file.
/// @throws InputError if it cannot be read or is not YAML
LocatedNode readYaml(const std::string& file);

} // namespace tokay::structure
