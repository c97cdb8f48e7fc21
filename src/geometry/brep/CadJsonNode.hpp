// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"

#include <yaml-cpp/node/node.h>

#include <string>
#include <vector>

namespace tokay::geometry {

/// A value of a cad.json file that knows where it stands: its errors begin with
/// "file:line:column: breps[0].faces[1].surface: ".
class CadJsonNode {
  public:
    /// @throws InputError if the file cannot be read or is no JSON.
    static CadJsonNode load(const std::string& path);

    InputError error(const std::string& message) const;

    bool has(const std::string& key) const;
    /// @throws InputError if the entry is missing.
    CadJsonNode child(const std::string& key) const;
    /// @throws InputError if this is no list.
    std::vector<CadJsonNode> items() const;
    /// Of the list at a key; none if there is no such key.
    std::vector<CadJsonNode> itemsOf(const std::string& key) const;

    /// @throws InputError if the value is of another kind or not finite.
    double number() const;
    int integer() const;
    bool boolean() const;
    std::string text() const;
    /// @param size  how many are wanted; 0 for any number
    std::vector<double> numbers(std::size_t size = 0) const;

    /// Runs a constructor, and lets its errors name this place.
    template <class Make>
    auto make(const Make& construct) const {
        try {
            return construct();
        } catch (const InputError& inner) {
            throw error(inner.what());
        }
    }

  private:
    CadJsonNode(std::string file, YAML::Node node, std::string path)
        : file_(std::move(file)), node_(std::move(node)), path_(std::move(path)) {}

    std::string file_;
    YAML::Node node_;
    std::string path_;
};

} // namespace tokay::geometry
