// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/LocatedNode.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace tokay {

namespace {

std::string contents(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw InputError(fmt::format("{}: the file cannot be opened; check its name", path));
    }
    std::ostringstream text;
    text << file.rdbuf();
    std::string result = text.str();
    // Blanks to JSON, but not to YAML.
    std::replace(result.begin(), result.end(), '\t', ' ');
    return result;
}

std::string describe(const YAML::Node& node) {
    switch (node.Type()) {
    case YAML::NodeType::Sequence:
        return "a list";
    case YAML::NodeType::Map:
        return "a map";
    case YAML::NodeType::Scalar:
        return fmt::format("'{}'", node.Scalar());
    default:
        return "nothing";
    }
}

InputError wrongType(const LocatedNode& node, const char* wanted) {
    return node.error(fmt::format("must be {}, but is {}", wanted, describe(node.node)));
}

} // namespace

LocatedNode LocatedNode::fromJsonFile(const std::string& file) {
    LocatedNode root{file, {}, ""};
    try {
        root.node = YAML::Load(contents(file));
    } catch (const YAML::Exception& error) {
        throw root.errorAt(error.mark, "this is not JSON: " + error.msg);
    }
    return root;
}

std::string LocatedNode::tablePath() const {
    std::string result;
    bool isIndex = false;
    for (const char c : path) {
        isIndex = isIndex && c != ']';
        if (!isIndex) {
            result += c;
        }
        isIndex = isIndex || c == '[';
    }
    return result;
}

InputError LocatedNode::error(const std::string& message) const {
    return errorAt(node.IsDefined() ? node.Mark() : YAML::Mark::null_mark(), message);
}

InputError LocatedNode::errorAt(const YAML::Mark& mark, const std::string& message) const {
    const std::string where =
        mark.is_null() ? file : fmt::format("{}:{}:{}", file, mark.line + 1, mark.column + 1);
    return InputError(path.empty() ? where + ": " + message : where + ": " + path + ": " + message);
}

bool LocatedNode::has(const std::string& key) const {
    return node.IsMap() && child(key).node.IsDefined();
}

LocatedNode LocatedNode::child(const std::string& key) const {
    const YAML::Node& map = node; // const, or else asking would create the entry
    return {file, map[key], path.empty() ? key : path + "." + key};
}

LocatedNode LocatedNode::item(std::size_t index) const {
    const YAML::Node& sequence = node;
    return {file, sequence[index], fmt::format("{}[{}]", path, index)};
}

LocatedNode LocatedNode::required(const std::string& key) const {
    if (!node.IsMap()) {
        throw wrongType(*this, fmt::format("a map with the key '{}'", key).c_str());
    }
    LocatedNode value = child(key);
    if (!value.node.IsDefined()) {
        throw error(fmt::format("the key '{}' is missing", key));
    }
    return value;
}

std::vector<LocatedNode> LocatedNode::items() const {
    if (!node.IsSequence()) {
        throw wrongType(*this, "a list");
    }
    std::vector<LocatedNode> items;
    for (const YAML::Node& value : node) { // item(i) of each would be quadratic
        items.push_back({file, value, fmt::format("{}[{}]", path, items.size())});
    }
    return items;
}

std::vector<LocatedNode> LocatedNode::itemsOf(const std::string& key) const {
    return has(key) ? child(key).items() : std::vector<LocatedNode>{};
}

double LocatedNode::number() const {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
        throw wrongType(*this, "a finite number");
    }
    return value;
}

int LocatedNode::integer() const {
    int value = 0;
    if (!node.IsScalar() || !YAML::convert<int>::decode(node, value)) {
        throw wrongType(*this, "an integer");
    }
    return value;
}

bool LocatedNode::boolean() const {
    if (!node.IsScalar() || (node.Scalar() != "true" && node.Scalar() != "false")) {
        throw wrongType(*this, "true or false");
    }
    return node.Scalar() == "true";
}

std::string LocatedNode::text() const {
    if (!node.IsScalar()) {
        throw wrongType(*this, "a text");
    }
    return node.Scalar();
}

std::vector<double> LocatedNode::numbers(std::size_t size) const {
    std::vector<double> values;
    for (const LocatedNode& value : items()) {
        values.push_back(value.number());
    }
    if (size > 0 && values.size() != size) {
        throw error(fmt::format("must have {} numbers, but has {}", size, values.size()));
    }
    return values;
}

} // namespace tokay
