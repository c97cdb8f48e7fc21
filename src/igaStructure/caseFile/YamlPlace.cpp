// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/YamlPlace.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace tokay::structure {

InputError YamlPlace::error(const std::string& message) const {
    return errorAt(node.IsDefined() ? node.Mark() : YAML::Mark::null_mark(), message);
}

InputError YamlPlace::errorAt(const YAML::Mark& mark, const std::string& message) const {
    const std::string where =
        mark.is_null() ? file : fmt::format("{}:{}:{}", file, mark.line + 1, mark.column + 1);
    return InputError(path.empty() ? where + ": " + message : where + ": " + path + ": " + message);
}

YamlPlace YamlPlace::child(const std::string& name) const {
    const std::string dot = path.empty() ? "" : ".";
    const YAML::Node& map = node; // const, or else asking would create the entry
    return {file, map[name], tablePath.empty() ? name : tablePath + "." + name, path + dot + name};
}

YamlPlace YamlPlace::item(std::size_t index) const {
    const YAML::Node& sequence = node;
    return {file, sequence[index], tablePath + "[]", fmt::format("{}[{}]", path, index)};
}

} // namespace tokay::structure
