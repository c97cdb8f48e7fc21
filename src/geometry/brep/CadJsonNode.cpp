// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/CadJsonNode.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace tokay::geometry {

namespace {

std::string contents(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw InputError(fmt::format("{}: the file cannot be opened. Check its name.", path));
    }
    std::ostringstream text;
    text << file.rdbuf();
    std::string result = text.str();
    // Blanks to JSON, but not to YAML.
    std::replace(result.begin(), result.end(), '\t', ' ');
    return result;
}

std::string kindOf(const YAML::Node& node) {
    switch (node.Type()) {
    case YAML::NodeType::Sequence:
        return "a list";
    case YAML::NodeType::Map:
        return "an object";
    case YAML::NodeType::Scalar:
        return fmt::format("\"{}\"", node.Scalar());
    default:
        return "nothing";
    }
}

} // namespace

CadJsonNode CadJsonNode::load(const std::string& path) {
    const std::string text = contents(path);
    try {
        return CadJsonNode(path, YAML::Load(text), "");
    } catch (const YAML::Exception& error) {
        throw InputError(fmt::format("{}:{}:{}: this is no JSON: {}.", path, error.mark.line + 1,
                                     error.mark.column + 1, error.msg));
    }
}

InputError CadJsonNode::error(const std::string& message) const {
    const YAML::Mark mark = node_.Mark();
    const std::string place =
        mark.is_null() ? file_ : fmt::format("{}:{}:{}", file_, mark.line + 1, mark.column + 1);
    return InputError(path_.empty() ? fmt::format("{}: {}", place, message)
                                    : fmt::format("{}: {}: {}", place, path_, message));
}

bool CadJsonNode::has(const std::string& key) const {
    return node_.IsMap() && node_[key].IsDefined();
}

CadJsonNode CadJsonNode::child(const std::string& key) const {
    if (!node_.IsMap()) {
        throw error(fmt::format("this is {}, but an object with the key \"{}\" is needed.",
                                kindOf(node_), key));
    }
    const YAML::Node& map = node_; // const, or else asking would create the entry
    const YAML::Node value = map[key];
    if (!value.IsDefined()) {
        throw error(fmt::format("the key \"{}\" is missing.", key));
    }
    return CadJsonNode(file_, value, path_.empty() ? key : path_ + "." + key);
}

std::vector<CadJsonNode> CadJsonNode::items() const {
    if (!node_.IsSequence()) {
        throw error(fmt::format("this is {}, but must be a list.", kindOf(node_)));
    }
    std::vector<CadJsonNode> items;
    std::size_t number = 0;
    for (const YAML::Node& item : node_) {
        items.push_back(CadJsonNode(file_, item, fmt::format("{}[{}]", path_, number++)));
    }
    return items;
}

std::vector<CadJsonNode> CadJsonNode::itemsOf(const std::string& key) const {
    return has(key) ? child(key).items() : std::vector<CadJsonNode>{};
}

double CadJsonNode::number() const {
    double value;
    if (!node_.IsScalar() || !YAML::convert<double>::decode(node_, value) ||
        !std::isfinite(value)) {
        throw error(fmt::format("this is {}, but must be a number.", kindOf(node_)));
    }
    return value;
}

int CadJsonNode::integer() const {
    int value;
    if (!node_.IsScalar() || !YAML::convert<int>::decode(node_, value)) {
        throw error(fmt::format("this is {}, but must be a whole number.", kindOf(node_)));
    }
    return value;
}

bool CadJsonNode::boolean() const {
    if (node_.IsScalar() && (node_.Scalar() == "true" || node_.Scalar() == "false")) {
        return node_.Scalar() == "true";
    }
    throw error(fmt::format("this is {}, but must be true or false.", kindOf(node_)));
}

std::string CadJsonNode::text() const {
    if (!node_.IsScalar()) {
        throw error(fmt::format("this is {}, but must be a text.", kindOf(node_)));
    }
    return node_.Scalar();
}

std::vector<double> CadJsonNode::numbers(std::size_t size) const {
    std::vector<double> values;
    for (const CadJsonNode& item : items()) {
        values.push_back(item.number());
    }
    if (size > 0 && values.size() != size) {
        throw error(
            fmt::format("this list has {} numbers, but must have {}.", values.size(), size));
    }
    return values;
}

} // namespace tokay::geometry
