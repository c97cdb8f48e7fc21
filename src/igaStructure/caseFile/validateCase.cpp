// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/validateCase.hpp"

#include "common/Formula.hpp"
#include "igaStructure/caseFile/CaseEntry.hpp"
#include "igaStructure/caseFile/Interval.hpp"
#include "igaStructure/caseFile/closestWord.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tokay::structure {

namespace {

std::string describe(const YAML::Node& node) {
    switch (node.Type()) {
    case YAML::NodeType::Map:
        return "a map";
    case YAML::NodeType::Sequence:
        return "a list";
    case YAML::NodeType::Scalar:
        return "'" + node.Scalar() + "'";
    default:
        return "nothing";
    }
}

InputError wrongType(const LocatedNode& place, const std::string& wanted) {
    return place.error(fmt::format("must be {}, but is {}", wanted, describe(place.node)));
}

std::string quotedList(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

void requireKnownOnce(const LocatedNode& map) {
    const std::vector<std::string> known = childNames(map.tablePath());
    std::map<std::string, int> lines;
    for (const auto& pair : map.node) {
        const std::string name = pair.first.IsScalar() ? pair.first.Scalar() : "";
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw map.errorAt(pair.first.Mark(),
                              fmt::format("unknown entry '{}'{}; known here: {}", name,
                                          suggestion(name, known), quotedList(known)));
        }
        const auto [first, isNew] = lines.emplace(name, pair.first.Mark().line + 1);
        if (!isNew) {
            throw map.errorAt(
                pair.first.Mark(),
                fmt::format("entry '{}' is given twice, first in line {}", name, first->second));
        }
    }
}

void requireWord(const LocatedNode& place, const CaseEntry& entry) {
    const std::vector<std::string> allowed = splitWords(entry.allowed);
    if (!place.node.IsScalar()) {
        throw wrongType(place, "one of: " + quotedList(allowed));
    }
    const std::string word = place.node.Scalar();
    if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) {
        throw place.error(fmt::format("'{}' is not allowed{}; allowed: {}", word,
                                      suggestion(word, allowed), quotedList(allowed)));
    }
}

void requireInside(const LocatedNode& place, double value, const CaseEntry& entry) {
    if (!entry.allowed.empty() && !Interval(entry.allowed).contains(value)) {
        throw place.error(fmt::format("{} is out of range; allowed: {}{}", place.node.Scalar(),
                                      entry.allowed, entry.unit.empty() ? "" : " " + entry.unit));
    }
}

void requireYesNo(const LocatedNode& place) {
    bool value = false;
    if (!place.node.IsScalar() || !YAML::convert<bool>::decode(place.node, value)) {
        throw wrongType(place, "yes or no");
    }
}

void requirePoint(const LocatedNode& place) {
    if (!place.node.IsSequence() || (place.node.size() != 2 && place.node.size() != 3)) {
        throw wrongType(place, "[x, y] or [x, y, z]");
    }
    for (std::size_t i = 0; i < place.node.size(); ++i) {
        readNumber(place.item(i));
    }
}

void requireScalar(const LocatedNode& place, const CaseEntry& entry) {
    switch (entry.kind) {
    case Kind::number:
    case Kind::numbers:
        requireInside(place, readNumber(place), entry);
        break;
    case Kind::integer:
    case Kind::integers:
        requireInside(place, readInteger(place), entry);
        break;
    case Kind::yesNo:
        requireYesNo(place);
        break;
    case Kind::word:
    case Kind::words:
        requireWord(place, entry);
        break;
    case Kind::formula:
    case Kind::formulas:
        if (!place.node.IsScalar()) {
            throw wrongType(place, "a number or a formula");
        }
        Formula(place.node.Scalar(), place.error("").what());
        break;
    case Kind::points:
        requirePoint(place);
        break;
    default:
        if (!place.node.IsScalar()) {
            throw wrongType(place, "a text");
        }
    }
}

bool isList(Kind kind) {
    return kind == Kind::mapList || kind == Kind::numbers || kind == Kind::integers ||
           kind == Kind::words || kind == Kind::formulas || kind == Kind::points;
}

void requireLength(const LocatedNode& list, const CaseEntry& entry) {
    if (!list.node.IsSequence()) {
        throw wrongType(list, entry.count > 0 ? fmt::format("a list of {}", entry.count)
                                              : "a list ([…], or lines that begin with -)");
    }
    const std::size_t size = list.node.size();
    if (entry.count > 0 && size != static_cast<std::size_t>(entry.count)) {
        throw list.error(fmt::format("must have {} values, but has {}", entry.count, size));
    }
    if (size == 0 && entry.kind != Kind::mapList) {
        throw list.error("is empty; give at least one value");
    }
}

void requireValue(const LocatedNode& place, const CaseEntry& entry) {
    if (entry.kind == Kind::map) {
        validateCase(place);
        return;
    }
    if (!isList(entry.kind)) {
        requireScalar(place, entry);
        return;
    }
    requireLength(place, entry);
    for (std::size_t i = 0; i < place.node.size(); ++i) {
        if (entry.kind == Kind::mapList) {
            validateCase(place.item(i));
        } else {
            requireScalar(place.item(i), entry);
        }
    }
}

} // namespace

void validateCase(const LocatedNode& map) {
    if (!map.node.IsMap()) {
        throw wrongType(map, "a map with the entries " + quotedList(childNames(map.tablePath())));
    }
    requireKnownOnce(map);
    for (const std::string& name : childNames(map.tablePath())) {
        const LocatedNode place = map.child(name);
        const CaseEntry& entry = *findCaseEntry(place.tablePath());
        if (place.node.IsDefined()) {
            requireValue(place, entry);
        } else if (entry.presence == Presence::required) {
            throw map.error(fmt::format("entry '{}' is missing: {}", name, entry.meaning));
        }
    }
}

double readNumber(const LocatedNode& place) {
    double value = 0;
    if (!place.node.IsScalar() || !YAML::convert<double>::decode(place.node, value)) {
        throw wrongType(place, "a number");
    }
    if (!std::isfinite(value)) {
        throw wrongType(place, "a finite number");
    }
    return value;
}

int readInteger(const LocatedNode& place) {
    int value = 0;
    if (!place.node.IsScalar() || !YAML::convert<int>::decode(place.node, value)) {
        throw wrongType(place, "an integer");
    }
    return value;
}

} // namespace tokay::structure
