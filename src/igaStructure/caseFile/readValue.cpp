// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/readValue.hpp"

#include "common/Formula.hpp"
#include "igaStructure/caseFile/closestWord.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <cmath>

namespace tokay::structure {

namespace {

std::string describe(const YAML::Node& node) {
    switch (node.Type()) {
    case YAML::NodeType::Map:
        return "a map";
    case YAML::NodeType::Sequence:
        return "a list";
    case YAML::NodeType::Scalar:
        return "'" + shortened(node.Scalar()) + "'";
    default:
        return "nothing";
    }
}

// In decimal digits, all of the text: YAML's own readers take 010 for 8.
template <class Value>
std::errc parse(const std::string& text, Value& value) {
    const char* begin = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-');
    const char* end = text.c_str() + text.size();
    const auto [last, error] = std::from_chars(begin, end, value);
    return error == std::errc() && last != end ? std::errc::invalid_argument : error;
}

void read(const LocatedNode& place, double& value) {
    const std::string text = place.node.IsScalar() ? place.node.Scalar() : "";
    const std::errc error = parse(text, value);
    double special = 0;
    if (error == std::errc::result_out_of_range ||
        (error == std::errc() && !std::isfinite(value)) ||
        (!text.empty() && text.find('.') != std::string::npos &&
         YAML::convert<double>::decode(place.node, special) && !std::isfinite(special))) {
        throw wrongKind(place, "a finite number (of double precision)");
    }
    if (error != std::errc()) {
        throw wrongKind(place, "a number");
    }
}

void read(const LocatedNode& place, int& value) {
    const std::errc error = parse(place.node.IsScalar() ? place.node.Scalar() : "", value);
    if (error == std::errc::result_out_of_range) {
        throw wrongKind(place, "an integer of at most 2147483647");
    }
    if (error != std::errc()) {
        throw wrongKind(place, "an integer");
    }
}

void read(const LocatedNode& place, bool& value) {
    if (!place.node.IsScalar() || !YAML::convert<bool>::decode(place.node, value)) {
        throw wrongKind(place, "yes or no");
    }
}

void read(const LocatedNode& place, std::string& value) {
    if (!place.node.IsScalar()) {
        throw wrongKind(place, "a text");
    }
    value = place.node.Scalar();
}

void read(const LocatedNode& place, Formula& value) {
    if (!place.node.IsScalar()) {
        throw wrongKind(place, "a number or a formula");
    }
    value = Formula(place.node.Scalar(), place.error("").what());
}

void read(const LocatedNode& place, Coordinates& value) {
    if (!place.node.IsSequence() || (place.node.size() != 2 && place.node.size() != 3)) {
        throw wrongKind(place, "[x, y] or [x, y, z]");
    }
    value.isSpatial = place.node.size() == 3;
    for (std::size_t i = 0; i < place.node.size(); ++i) {
        read(place.item(i), value.at[i]);
    }
}

/// Reads the value of one entry, whatever its kind.
class ValueReader {
  public:
    ValueReader(const LocatedNode& place, const Entry& entry) : place_(place), entry_(entry) {}

    template <class Value>
    void operator()(Value* value) const {
        readItem(place_, *value);
    }

    template <class Value>
    void operator()(std::vector<Value>* values) const {
        requireList(place_);
        if (place_.node.size() == 0) {
            throw place_.error("is empty; give at least one value");
        }
        values->resize(place_.node.size());
        for (std::size_t i = 0; i < values->size(); ++i) {
            readItem(place_.item(i), (*values)[i]);
        }
    }

    template <class Value>
    void operator()(const FixedList<Value>& values) const {
        if (!place_.node.IsSequence()) {
            throw wrongKind(place_, fmt::format("a list of {}", values.size));
        }
        if (place_.node.size() != values.size) {
            throw place_.error(fmt::format("must have {} value{}, but has {}", values.size,
                                           values.size == 1 ? "" : "s", place_.node.size()));
        }
        for (std::size_t i = 0; i < values.size; ++i) {
            readItem(place_.item(i), values.first[i]);
        }
    }

    void operator()(const ChoiceSlot& slot) const {
        if (!slot.isList) {
            slot.set({readChoice(place_, entry_.alternatives)});
            return;
        }
        requireList(place_);
        if (place_.node.size() == 0) {
            throw place_.error("is empty; give at least one value");
        }
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < place_.node.size(); ++i) {
            chosen.push_back(readChoice(place_.item(i), entry_.alternatives));
        }
        slot.set(chosen);
    }

    void operator()(const Section&) const {}
    void operator()(const SectionList&) const {}

  private:
    template <class Value>
    void readItem(const LocatedNode& place, Value& value) const {
        read(place, value);
        if constexpr (std::is_arithmetic_v<Value>) {
            if (!entry_.range.contains(value)) {
                throw place.error(outOfRange(place.node.Scalar(), entry_));
            }
        }
    }

    const LocatedNode& place_;
    const Entry& entry_;
};

} // namespace

void readValue(const LocatedNode& place, const Entry& entry, const Slot& slot) {
    std::visit(ValueReader(place, entry), slot);
}

std::size_t readChoice(const LocatedNode& place, const std::vector<Alternative>& alternatives) {
    std::vector<std::string> names;
    for (const Alternative& alternative : alternatives) {
        names.push_back(alternative.name);
    }
    if (!place.node.IsScalar()) {
        throw wrongKind(place, "one of: " + listed(names));
    }
    const std::string word = place.node.Scalar();
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k] == word) {
            return k;
        }
    }
    throw place.error(fmt::format("'{}' is not allowed{}; allowed: {}", shortened(word),
                                  suggestion(word, names), listed(names)));
}

void requireList(const LocatedNode& list) {
    if (!list.node.IsSequence()) {
        throw wrongKind(list, "a list ([…], or lines that begin with -)");
    }
}

InputError wrongKind(const LocatedNode& place, const std::string& wanted) {
    return place.error(fmt::format("must be {}, but is {}", wanted, describe(place.node)));
}

std::string listed(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace tokay::structure
