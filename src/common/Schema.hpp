// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Located.hpp"
#include "common/Range.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace tokay {

class Formula;
class Schema;

/// Point as a file gives it: [x, y] or [x, y, z].
struct Coordinates {
    std::array<double, 3> at = {0, 0, 0};
    bool isSpatial = false; ///< whether z is given, be it 0
};

/// List of a fixed length in options.
template <class Value>
struct FixedList {
    Value* first;
    std::size_t size;
};

/// One word, or several, in options, as indices into the entry's choices.
struct ChoiceSlot {
    bool isList;
    std::function<void(const std::vector<std::size_t>&)> set;
    std::function<std::vector<std::size_t>()> get;
};

/// Options inside options.
struct Section {
    const Schema* schema;
    void* options;
};

/// List of options inside options.
struct SectionList {
    const Schema* schema;
    std::function<void*()> append;
};

/// Where a value is stored, and so what its kind is.
using Slot =
    std::variant<double*, int*, bool*, std::string*, Formula*, Coordinates*, FixedList<double>,
                 FixedList<int>, FixedList<Formula>, std::vector<double>*, std::vector<int>*,
                 std::vector<std::string>*, std::vector<Formula>*, std::vector<Coordinates>*,
                 ChoiceSlot, Section, SectionList>;

/// What holds where a file does not give an entry: nothing (`required`), the value that
/// the options have when they are made, or what a text says.
struct Default {
    bool isRequired = false;
    std::string text = {};
};
inline const Default required = {true};
inline Default otherwise(std::string text) {
    return {false, std::move(text)};
}

/// A word that may be chosen: its meaning, and the entries that come with it.
struct Alternative;

/// One option: all that a reader, a range check, a manual and a log need of it.
struct Entry {
    std::string name;
    Range range = {};
    std::string unit = {}; ///< empty: none
    std::string meaning = {};
    Default fallback = {};
    std::vector<Alternative> alternatives = {}; ///< of a choice
    /// The value in options; makes it if it is optional.
    std::function<Slot(void* options)> slot = {};
    /// Whether an optional value is there.
    std::function<bool(void* options)> isSet = {};
};

/// All entries of options, whatever the type of these. Made by SchemaOf; see there.
class Schema {
  public:
    std::vector<Entry> entries;
    std::vector<std::string> exactlyOneOf = {}; ///< exclusive entries, if not empty
    std::function<std::shared_ptr<void>()> makeDefaults = {};
    std::function<void(void* options, const Located&)> locate = {}; ///< empty: not Located

    /// The same entries of options of which a function finds those of this schema.
    Schema in(const std::function<void*(void*)>& part) const;

    /// Entries that options may have: these, and those of the alternatives that they choose.
    std::vector<const Entry*> entriesOf(void* options) const;
};

struct Alternative {
    std::string name;
    std::string meaning;
    Schema own;
};

/// Schema of a type of options: a table of rows {name, member, range, unit, meaning}
/// for numbers, {name, member, meaning} for other values and for options with a schema
/// of their own, {name, member, choices, meaning} for words; each may end with a Default.
template <class Options>
class SchemaOf;

/// A word that stands for a value, an enumerator or a factory.
/// @tparam Options  to which the entries belong that come with this choice
template <class Value, class Options = void>
struct Choice {
    Choice(std::string theName, Value theValue, std::string theMeaning = "",
           SchemaOf<Options> ownEntries = SchemaOf<Options>())
        : name(std::move(theName)), value(std::move(theValue)), meaning(std::move(theMeaning)),
          own(std::move(ownEntries)) {}

    std::string name;
    Value value;
    std::string meaning;
    SchemaOf<Options> own;
};

template <class Value, class Options = void>
using Choices = std::vector<Choice<Value, Options>>;

/// The choice that stands for a value.
template <class Value, class Options>
const std::string& nameOf(const Value& value, const Choices<Value, Options>& choices) {
    std::size_t k = 0;
    while (k + 1 < choices.size() && !(choices[k].value == value)) {
        ++k;
    }
    return choices[k].name;
}

namespace schemaDetail {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t n>
struct IsArray<std::array<T, n>> : std::true_type {};

template <class Value>
Slot slotOf(Value& value) {
    if constexpr (IsOptional<Value>::value) {
        return slotOf(value ? *value : value.emplace());
    } else if constexpr (std::is_constructible_v<Slot, Value*>) {
        return &value;
    } else if constexpr (IsArray<Value>::value) {
        return FixedList<typename Value::value_type>{value.data(), value.size()};
    } else if constexpr (IsVector<Value>::value) {
        return SectionList{&Value::value_type::schema(),
                           [&value] { return &value.emplace_back(); }};
    } else {
        return Section{&Value::schema(), &value};
    }
}

template <class Member, class Value, class Options>
Slot choiceSlot(Member& member, const Choices<Value, Options>& choices) {
    const auto indexOf = [&choices](const Value& value) {
        std::size_t k = 0;
        while (k < choices.size() && !(choices[k].value == value)) {
            ++k;
        }
        return k;
    };
    if constexpr (IsVector<Member>::value) {
        return ChoiceSlot{true,
                          [&](const std::vector<std::size_t>& chosen) {
                              member.clear();
                              for (const std::size_t k : chosen) {
                                  member.push_back(choices[k].value);
                              }
                          },
                          [&member, indexOf] {
                              std::vector<std::size_t> chosen;
                              for (const Value& value : member) {
                                  chosen.push_back(indexOf(value));
                              }
                              return chosen;
                          }};
    } else if constexpr (IsOptional<Member>::value) {
        return choiceSlot(member ? *member : member.emplace(), choices);
    } else {
        return ChoiceSlot{
            false,
            [&](const std::vector<std::size_t>& chosen) { member = choices[chosen.front()].value; },
            [&member, indexOf] { return std::vector<std::size_t>{indexOf(member)}; }};
    }
}

template <class Value>
bool isSet(const Value& value) {
    if constexpr (IsOptional<Value>::value) {
        return value.has_value();
    } else {
        return true;
    }
}

} // namespace schemaDetail

/// A row of a schema; see SchemaOf.
template <class Options>
class EntryOf {
  public:
    template <class Member, class Owner>
    EntryOf(std::string name, Member Owner::*member, Range range, std::string unit,
            std::string meaning, Default fallback = {})
        : entry_{std::move(name), std::move(range), std::move(unit), std::move(meaning),
                 std::move(fallback)} {
        setSlot<Member>(member, [](Member& value) { return schemaDetail::slotOf(value); });
    }

    template <class Member, class Owner>
    EntryOf(std::string name, Member Owner::*member, std::string meaning, Default fallback = {})
        : EntryOf(std::move(name), member, Range(), "", std::move(meaning), std::move(fallback)) {}

    /// @param choices  must live as long as the schema
    template <class Member, class Owner, class Value, class Own>
    EntryOf(std::string name, Member Owner::*member, const Choices<Value, Own>& choices,
            std::string meaning, Default fallback = {})
        : entry_{std::move(name), {}, "", std::move(meaning), std::move(fallback)} {
        for (const Choice<Value, Own>& choice : choices) {
            entry_.alternatives.push_back({choice.name, choice.meaning, choice.own});
        }
        setSlot<Member>(
            member, [&choices](Member& value) { return schemaDetail::choiceSlot(value, choices); });
    }

    /// A map of entries that are members of the same options.
    EntryOf(std::string name, const SchemaOf<Options>& inside, std::string meaning,
            Default fallback = {})
        : entry_{std::move(name), {}, "", std::move(meaning), std::move(fallback)} {
        entry_.slot = [inside = std::make_shared<SchemaOf<Options>>(inside)](void* options) {
            return Section{inside.get(), options};
        };
        entry_.isSet = [](void*) { return true; };
    }

    const Entry& entry() const { return entry_; }

  private:
    template <class Member, class ToSlot>
    void setSlot(Member Options::*member, ToSlot toSlot) {
        entry_.slot = [member, toSlot](void* options) {
            return toSlot(static_cast<Options*>(options)->*member);
        };
        entry_.isSet = [member](void* options) {
            return schemaDetail::isSet(static_cast<Options*>(options)->*member);
        };
    }

    Entry entry_;
};

template <class Options>
class SchemaOf : public Schema {
  public:
    SchemaOf() : SchemaOf(std::initializer_list<EntryOf<Options>>()) {}
    SchemaOf(std::initializer_list<EntryOf<Options>> rows) {
        for (const EntryOf<Options>& row : rows) {
            entries.push_back(row.entry());
        }
        makeDefaults = [] { return std::make_shared<Options>(); };
        if constexpr (std::is_base_of_v<Located, Options>) {
            locate = [](void* options, const Located& location) {
                static_cast<Located&>(*static_cast<Options*>(options)) = location;
            };
        }
    }

    /// Adds the entries of a base or of a member, which then read as one's own.
    template <class Base>
    SchemaOf with(const SchemaOf<Base>& base) && {
        append(base.in([](void* options) -> void* {
            return static_cast<Base*>(static_cast<Options*>(options));
        }));
        return std::move(*this);
    }
    template <class Part, class Owner>
    SchemaOf with(Part Owner::*part, const SchemaOf<Part>& schema) && {
        append(schema.in(
            [part](void* options) -> void* { return &(static_cast<Options*>(options)->*part); }));
        return std::move(*this);
    }

    /// Demands that exactly one of the entries is given that the schema has so far.
    SchemaOf exactlyOne() && {
        for (const Entry& entry : entries) {
            exactlyOneOf.push_back(entry.name);
        }
        return std::move(*this);
    }

  private:
    void append(const Schema& more) {
        entries.insert(entries.end(), more.entries.begin(), more.entries.end());
    }
};

template <>
class SchemaOf<void> : public Schema {};

/// Checks options made in code as a reader checks those of a file.
/// @throws InputError "name: value is out of range; allowed: range"
void requireInRange(const Schema& schema, void* options);

/// Message that a value is out of an entry's range.
std::string outOfRange(const std::string& value, const Entry& entry);

} // namespace tokay
