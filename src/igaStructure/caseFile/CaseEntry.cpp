// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/CaseEntry.hpp"

#include <fmt/format.h>

#include <sstream>

namespace tokay::structure {

namespace {

std::string parentOf(const std::string& path) {
    const auto dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string nameOf(const std::string& path) {
    std::string name = path.substr(path.rfind('.') + 1); // npos + 1 is 0
    return name;
}

const char* kindText(Kind kind) {
    switch (kind) {
    case Kind::map:
        return "map";
    case Kind::mapList:
        return "list of maps";
    case Kind::number:
        return "number";
    case Kind::integer:
        return "integer";
    case Kind::yesNo:
        return "yes or no";
    case Kind::word:
        return "word";
    case Kind::text:
        return "text";
    case Kind::formula:
        return "number or formula";
    case Kind::numbers:
        return "list of numbers";
    case Kind::integers:
        return "list of integers";
    case Kind::words:
        return "list of words";
    case Kind::formulas:
        return "list of numbers or formulas";
    case Kind::points:
        return "list of [x, y] or [x, y, z]";
    }
    return "";
}

std::string defaultText(const CaseEntry& entry) {
    switch (entry.presence) {
    case Presence::required:
        return "required";
    case Presence::optional:
        return "optional";
    case Presence::defaulted:
        return entry.kind == Kind::map ? "optional" : "`" + entry.fallback + "`";
    }
    return "";
}

std::string tableRow(const CaseEntry& entry) {
    const std::string count = entry.count > 0 ? fmt::format(" ({})", entry.count) : "";
    const std::string allowed = entry.kind == Kind::word || entry.kind == Kind::words
                                    ? fmt::format("{}", fmt::join(splitWords(entry.allowed), ", "))
                                    : entry.allowed;
    return fmt::format("| `{}` | {}{} | {} | {} | {} | {} |\n", entry.path, kindText(entry.kind),
                       count, entry.unit, defaultText(entry), allowed, entry.meaning);
}

} // namespace

const CaseEntry* findCaseEntry(const std::string& path) {
    for (const CaseEntry& entry : caseEntries()) {
        if (entry.path == path) {
            return &entry;
        }
    }
    return nullptr;
}

std::vector<std::string> childNames(const std::string& path) {
    std::vector<std::string> names;
    for (const CaseEntry& entry : caseEntries()) {
        if (parentOf(entry.path) == path) {
            names.push_back(nameOf(entry.path));
        }
    }
    return names;
}

std::vector<std::string> splitWords(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return words;
}

std::string describeCaseEntries() {
    std::string text;
    std::string topic = " ";
    for (const CaseEntry& entry : caseEntries()) {
        const std::string first = entry.path.substr(0, entry.path.find_first_of(".["));
        if (first != topic) {
            topic = first;
            text += fmt::format("\n## {}\n\n", topic);
            text += "| entry | type | unit | default | allowed | meaning |\n"
                    "|---|---|---|---|---|---|\n";
        }
        text += tableRow(entry);
    }
    return text;
}

} // namespace tokay::structure
