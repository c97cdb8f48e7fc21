// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/describeSchema.hpp"

#include "common/Formula.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

constexpr auto heading = "| entry | type | unit | default | allowed | meaning |\n"
                         "|---|---|---|---|---|---|\n";

struct KindName {
    std::string operator()(const double*) const { return "number"; }
    std::string operator()(const int*) const { return "integer"; }
    std::string operator()(const bool*) const { return "yes or no"; }
    std::string operator()(const std::string*) const { return "text"; }
    std::string operator()(const Formula*) const { return "number or formula"; }
    std::string operator()(const Coordinates*) const { return "[x, y] or [x, y, z]"; }
    std::string operator()(const ChoiceSlot& slot) const {
        return slot.isList ? "list of words" : "word";
    }
    std::string operator()(const Section&) const { return "map"; }
    std::string operator()(const SectionList&) const { return "list of maps"; }
    template <class Value>
    std::string operator()(const FixedList<Value>& list) const {
        return fmt::format("list of {}s ({})", one(list.first), list.size);
    }
    template <class Value>
    std::string operator()(const std::vector<Value>*) const {
        return "list of " + one(static_cast<const Value*>(nullptr)) + "s";
    }

  private:
    template <class Value>
    std::string one(const Value* value) const {
        if constexpr (std::is_same_v<Value, Formula>) {
            return "number or formula";
        } else {
            return (*this)(value);
        }
    }
};

std::string words(const Entry& entry, const std::vector<std::size_t>& indices) {
    std::vector<std::string> names;
    for (const std::size_t k : indices) {
        names.push_back(entry.alternatives.at(k).name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// The value of an entry as a file would give it; empty where there is none to show.
class ValueText {
  public:
    explicit ValueText(const Entry& entry) : entry_(entry) {}

    std::string operator()(double* value) const { return fmt::format("{:g}", *value); }
    std::string operator()(int* value) const { return fmt::format("{}", *value); }
    std::string operator()(bool* value) const { return *value ? "yes" : "no"; }
    std::string operator()(std::string* value) const { return *value; }
    std::string operator()(const ChoiceSlot& slot) const { return words(entry_, slot.get()); }
    template <class Other>
    std::string operator()(const Other&) const {
        return "";
    }

  private:
    const Entry& entry_;
};

std::string valueText(const Entry& entry, void* options) {
    return entry.isSet(options) ? std::visit(ValueText(entry), entry.slot(options)) : "";
}

std::string fallbackText(const Entry& entry, void* options) {
    if (entry.fallback.isRequired) {
        return "required";
    }
    if (!entry.fallback.text.empty()) {
        return entry.fallback.text;
    }
    const std::string value = valueText(entry, options);
    return value.empty() ? "none" : "`" + value + "`";
}

std::string allowedText(const Entry& entry) {
    if (entry.alternatives.empty()) {
        return entry.range.text();
    }
    std::vector<std::string> names;
    for (const Alternative& alternative : entry.alternatives) {
        names.push_back(alternative.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string meaningText(const Entry& entry) {
    std::string text = entry.meaning;
    for (const Alternative& alternative : entry.alternatives) {
        if (!alternative.meaning.empty()) {
            text += fmt::format(" {}: {}", alternative.name, alternative.meaning);
        }
    }
    return text;
}

} // namespace

std::string SchemaTables::table(const std::string& path, const Schema& schema) {
    const std::shared_ptr<void> options = schema.makeDefaults();
    std::string text = "\n" + (heading + rows(path, schema, options.get()));
    text += below_;
    below_.clear();
    return text;
}

std::string SchemaTables::rows(const std::string& path, const Schema& schema, void* options) {
    std::string text;
    for (const Entry& entry : schema.entries) {
        text += row(path.empty() ? entry.name : path + "." + entry.name, entry, options);
    }
    return text;
}

std::string SchemaTables::row(const std::string& path, const Entry& entry, void* options) {
    const std::string fallback = fallbackText(entry, options); // before slot makes a value
    const Slot slot = entry.slot(options);
    std::string text =
        fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", path, std::visit(KindName(), slot),
                    entry.unit, fallback, allowedText(entry), meaningText(entry));
    if (const auto* section = std::get_if<Section>(&slot)) {
        if (written_.emplace(path, section->schema).second) {
            text += rows(path, *section->schema, section->options);
        }
    } else if (const auto* list = std::get_if<SectionList>(&slot)) {
        if (written_.emplace(path, list->schema).second) {
            text += rows(path + "[]", *list->schema, list->append());
        }
    }
    for (const Alternative& alternative : entry.alternatives) {
        if (!alternative.own.entries.empty()) {
            const std::string parent = path.substr(0, path.rfind('.'));
            const std::string own = rows(parent, alternative.own, options);
            below_ += fmt::format("\n`{}: {}`\n\n{}{}", path, alternative.name, heading, own);
        }
    }
    return text;
}

std::string describeOptions(const Schema& schema, void* options) {
    std::vector<std::string> texts;
    std::string sections;
    for (const Entry* entry : schema.entriesOf(options)) {
        if (!entry->isSet(options)) {
            continue;
        }
        const Slot slot = entry->slot(options);
        if (const auto* section = std::get_if<Section>(&slot)) {
            sections += fmt::format("\n  {} {}", entry->name,
                                    describeOptions(*section->schema, section->options));
            continue;
        }
        const std::string value = valueText(*entry, options);
        if (!value.empty()) {
            texts.push_back(entry->name == "type" ? value : entry->name + " " + value);
        }
    }
    return fmt::format("{}", fmt::join(texts, ", ")) + sections;
}

} // namespace tokay::structure
