// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/readOptions.hpp"

#include "igaStructure/caseFile/closestWord.hpp"
#include "igaStructure/caseFile/readValue.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace tokay::structure {

namespace {

using Entries = std::vector<const Entry*>;

std::vector<std::string> namesOf(const Entries& entries) {
    std::vector<std::string> names;
    for (const Entry* entry : entries) {
        names.push_back(entry->name);
    }
    return names;
}

template <class Named>
const Named* find(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Named& named) { return named.name == name; });
    return found == all.end() ? nullptr : &*found;
}

/// Reads one map.
class MapReader {
  public:
    MapReader(const LocatedNode& map, const Schema& schema, void* options, const MadeChoice& choice)
        : map_(map), schema_(schema), options_(options), choice_(choice) {}

    void read() {
        if (!map_.node.IsMap()) {
            throw wrongKind(map_, "a map with the entries " +
                                      listed(namesOf(schema_.entriesOf(options_))));
        }
        choose();
        requireKnownOnce();
        for (const Entry* entry : entries_) {
            readEntry(*entry);
        }
        requireExactlyOne();
        locate();
    }

  private:
    // Choices come first: they decide which other entries there are.
    void choose() {
        for (const Entry& entry : schema_.entries) {
            const LocatedNode place = map_.child(entry.name);
            if (entry.alternatives.empty() || !place.node.IsDefined()) {
                continue;
            }
            readEntry(entry);
        }
        entries_ = schema_.entriesOf(options_);
    }

    void readEntry(const Entry& entry) const {
        const LocatedNode place = map_.child(entry.name);
        if (!place.node.IsDefined()) {
            if (entry.fallback.isRequired) {
                throw map_.error(
                    fmt::format("entry '{}' is missing: {}", entry.name, entry.meaning));
            }
            return;
        }
        const Slot slot = entry.slot(options_);
        if (const auto* section = std::get_if<Section>(&slot)) {
            readOptions(place, *section->schema, section->options, inside(entry));
        } else if (const auto* list = std::get_if<SectionList>(&slot)) {
            requireList(place);
            for (std::size_t i = 0; i < place.node.size(); ++i) {
                readOptions(place.item(i), *list->schema, list->append(), inside(entry));
            }
        } else {
            readValue(place, entry, slot);
        }
    }

    void requireExactlyOne() const {
        const std::vector<std::string>& names = schema_.exactlyOneOf;
        const auto isGiven = [&](const std::string& name) {
            return map_.child(name).node.IsDefined();
        };
        if (!names.empty() && std::count_if(names.begin(), names.end(), isGiven) != 1) {
            throw map_.error("give exactly one of: " + listed(names));
        }
    }

    // The choice, as it concerns a map or list of maps inside this one.
    MadeChoice inside(const Entry& entry) const {
        MadeChoice result{choice_.name, {}};
        for (const Schema* other : choice_.others) {
            const Entry* same = find(other->entries, entry.name);
            const std::shared_ptr<void> defaults = other->makeDefaults();
            const Slot slot = same ? same->slot(defaults.get()) : Slot();
            if (const auto* section = std::get_if<Section>(&slot)) {
                result.others.push_back(section->schema);
            } else if (const auto* list = std::get_if<SectionList>(&slot)) {
                result.others.push_back(list->schema);
            }
        }
        return result;
    }

    void requireKnownOnce() const {
        const std::vector<std::string> known = namesOf(entries_);
        std::map<std::string, int> lines;
        for (const auto& pair : map_.node) {
            const std::string name = pair.first.IsScalar() ? pair.first.Scalar() : "";
            if (std::find(known.begin(), known.end(), name) == known.end()) {
                throw map_.errorAt(pair.first.Mark(), unknown(name, known));
            }
            const auto [first, isNew] = lines.emplace(name, pair.first.Mark().line + 1);
            if (!isNew) {
                throw map_.errorAt(pair.first.Mark(),
                                   fmt::format("entry '{}' is given twice, first in line {}", name,
                                               first->second));
            }
        }
    }

    std::string unknown(const std::string& name, const std::vector<std::string>& known) const {
        const std::string owner = choiceWithout(name);
        return owner.empty() ? fmt::format("unknown entry '{}'{}; known here: {}", name,
                                           suggestion(name, known), listed(known))
                             : fmt::format("'{}' is not an option of {}; allowed: {}", name, owner,
                                           listed(known));
    }

    // The choice but for which the entry would be known; empty if there is none.
    std::string choiceWithout(const std::string& name) const {
        for (const Entry& entry : schema_.entries) {
            for (const Alternative& alternative : entry.alternatives) {
                if (find(alternative.own.entries, name)) {
                    const Slot slot = entry.slot(options_);
                    return entry.alternatives[std::get<ChoiceSlot>(slot).get().front()].name;
                }
            }
        }
        const bool isOfAnother =
            std::any_of(choice_.others.begin(), choice_.others.end(),
                        [&](const Schema* other) { return find(other->entries, name) != nullptr; });
        return isOfAnother ? choice_.name : "";
    }

    void locate() const {
        if (!schema_.locate) {
            return;
        }
        Located location;
        location.where = [map = map_](const std::string& entry) {
            if (entry.empty()) {
                return std::string(map.error("").what());
            }
            const LocatedNode place = map.child(entry);
            return place.node.IsDefined() ? std::string(place.error("").what())
                                          : map.error(entry + ": ").what();
        };
        schema_.locate(options_, location);
    }

    const LocatedNode& map_;
    const Schema& schema_;
    void* options_;
    const MadeChoice& choice_;
    Entries entries_;
};

} // namespace

void readOptions(const LocatedNode& map, const Schema& schema, void* options,
                 const MadeChoice& choice) {
    MapReader(map, schema, options, choice).read();
}

LocatedNode parseYaml(const std::string& text, const std::string& file) {
    LocatedNode root{file, {}, ""};
    try {
        root.node = YAML::Load(text);
    } catch (const YAML::ParserException& exception) {
        throw root.errorAt(exception.mark, "this is not YAML: " + exception.msg);
    }
    return root;
}

LocatedNode readYaml(const std::string& file) {
    std::ifstream stream(file);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf())) {
        throw InputError(fmt::format("cannot read case file '{}': {}", file,
                                     errno ? std::strerror(errno) : "it is empty"));
    }
    return parseYaml(text.str(), file);
}

} // namespace tokay::structure
