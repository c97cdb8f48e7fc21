// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace tokay {

/// Node of a YAML or JSON file that knows its location, so that every error
/// found in it begins with "file:line:column: loads[0].edge: ".
struct LocatedNode {
    std::string file;
    YAML::Node node;
    std::string path; ///< from the root, as the user writes it: "loads[0].edge"

    /// Reads a JSON file.
    /// @throws InputError if the file cannot be read or is not JSON.
    static LocatedNode fromJsonFile(const std::string& file);

    /// Path without indices, as tables of entries name it: "loads[].edge".
    std::string tablePath() const;

    InputError error(const std::string& message) const;
    /// Error at a mark of the caller's instead of the node's own.
    InputError errorAt(const YAML::Mark& mark, const std::string& message) const;

    /// True if this is a map that has the key.
    bool has(const std::string& key) const;
    /// Node at a key; undefined if there is none.
    LocatedNode child(const std::string& key) const;
    LocatedNode item(std::size_t index) const;

    /// Node at a key that must be there.
    /// @throws InputError if it is missing.
    LocatedNode required(const std::string& key) const;
    /// @throws InputError if this is not a list.
    std::vector<LocatedNode> items() const;
    /// Items of the list at a key; none if the key is missing.
    std::vector<LocatedNode> itemsOf(const std::string& key) const;

    /// Values of a scalar.
    /// @throws InputError if it is of another kind or not finite.
    double number() const;
    int integer() const;
    bool boolean() const;
    std::string text() const;
    /// Numbers of a list.
    /// @param size  length that the list must have; 0 for any
    std::vector<double> numbers(std::size_t size = 0) const;

    /// Runs a function and prefixes the errors that it throws with this location.
    template <class Make>
    auto make(const Make& construct) const {
        try {
            return construct();
        } catch (const InputError& inner) {
            throw error(inner.what());
        }
    }
};

} // namespace tokay
