// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/caseFile/CaseSection.hpp"

#include "common/digest.hpp"
#include "igaStructure/caseFile/CaseEntry.hpp"
#include "igaStructure/caseFile/validateCase.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace tokay::structure {

struct CaseSection::Implementation {
    LocatedNode place;

    // The entry as given, or its default.
    LocatedNode value(const std::string& name) const {
        const LocatedNode given = place.child(name);
        if (given.node.IsDefined()) {
            return given;
        }
        const CaseEntry* entry = findCaseEntry(given.tablePath());
        assert(entry && entry->presence == Presence::defaulted);
        return {given.file, YAML::Load(entry->fallback), given.path};
    }

    void requireCount(const std::string& name, std::size_t count) const {
        const LocatedNode list = value(name);
        if (list.node.size() != count) {
            throw list.error(fmt::format("must have {} value{} here, but has {}", count,
                                         count == 1 ? "" : "s", list.node.size()));
        }
    }

    template <class Read>
    auto values(const std::string& name, Read read) const {
        const LocatedNode list = value(name);
        std::vector<decltype(read(list))> result;
        for (std::size_t i = 0; i < list.node.size(); ++i) {
            result.push_back(read(list.item(i)));
        }
        return result;
    }
};

namespace {

Formula readFormula(const LocatedNode& place) {
    return Formula(place.node.Scalar(), place.error("").what());
}

std::string readFile(const std::string& fileName) {
    std::ifstream file(fileName);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) {
        throw InputError(fmt::format("cannot read case file '{}': {}", fileName,
                                     errno ? std::strerror(errno) : "it is empty"));
    }
    return text.str();
}

} // namespace

CaseSection::CaseSection(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
CaseSection::CaseSection(const CaseSection& other)
    : implementation_(std::make_unique<Implementation>(*other.implementation_)) {}
CaseSection::CaseSection(CaseSection&&) noexcept = default;
CaseSection& CaseSection::operator=(CaseSection&&) noexcept = default;
CaseSection::~CaseSection() = default;

CaseSection CaseSection::fromFile(const std::string& fileName) {
    return fromText(readFile(fileName), fileName);
}

CaseSection CaseSection::fromText(const std::string& text, const std::string& fileName) {
    LocatedNode root{fileName, {}, ""};
    try {
        root.node = YAML::Load(text);
    } catch (const YAML::ParserException& exception) {
        throw root.errorAt(exception.mark, "this is not YAML: " + exception.msg);
    }
    validateCase(root);
    return CaseSection(std::make_unique<Implementation>(Implementation{root}));
}

bool CaseSection::has(const std::string& name) const {
    return implementation_->place.child(name).node.IsDefined();
}

std::vector<std::string> CaseSection::givenNames() const {
    std::vector<std::string> names;
    for (const auto& pair : implementation_->place.node) {
        names.push_back(pair.first.Scalar());
    }
    return names;
}

std::string CaseSection::digest() const {
    YAML::Emitter text;
    text << YAML::Flow << implementation_->place.node;
    return tokay::digest(text.c_str());
}

void CaseSection::require(const std::string& name, const std::string& reason) const {
    if (!has(name)) {
        throw error("", fmt::format("entry '{}' is missing: {}", name, reason));
    }
}

std::string CaseSection::exactlyOne(const std::vector<std::string>& names) const {
    const std::vector<std::string> given = givenNames();
    if (given.size() != 1 || std::find(names.begin(), names.end(), given[0]) == names.end()) {
        throw error("", fmt::format("give exactly one of: {}", fmt::join(names, ", ")));
    }
    return given[0];
}

double CaseSection::number(const std::string& name) const {
    return readNumber(implementation_->value(name));
}

int CaseSection::integer(const std::string& name) const {
    return readInteger(implementation_->value(name));
}

bool CaseSection::yesNo(const std::string& name) const {
    return implementation_->value(name).node.as<bool>();
}

std::string CaseSection::text(const std::string& name) const {
    return implementation_->value(name).node.Scalar();
}

Formula CaseSection::formula(const std::string& name) const {
    return readFormula(implementation_->value(name));
}

std::vector<double> CaseSection::numbers(const std::string& name) const {
    return implementation_->values(name, readNumber);
}

std::vector<int> CaseSection::integers(const std::string& name) const {
    return implementation_->values(name, readInteger);
}

std::vector<std::string> CaseSection::words(const std::string& name) const {
    return implementation_->values(name, [](const LocatedNode& p) { return p.node.Scalar(); });
}

std::vector<Formula> CaseSection::formulas(const std::string& name) const {
    return implementation_->values(name, readFormula);
}

std::vector<std::vector<double>> CaseSection::points(const std::string& name) const {
    return implementation_->values(
        name, [](const LocatedNode& p) { return p.node.as<std::vector<double>>(); });
}

std::vector<double> CaseSection::numbers(const std::string& name, std::size_t count) const {
    implementation_->requireCount(name, count);
    return numbers(name);
}

std::vector<int> CaseSection::integers(const std::string& name, std::size_t count) const {
    implementation_->requireCount(name, count);
    return integers(name);
}

std::vector<Formula> CaseSection::formulas(const std::string& name, std::size_t count) const {
    implementation_->requireCount(name, count);
    return formulas(name);
}

std::vector<std::string> CaseSection::words(const std::string& name,
                                            const std::vector<std::string>& allowed,
                                            const std::string& owner) const {
    std::vector<std::string> given = words(name);
    for (const std::string& word : given) {
        if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) {
            throw error(name, fmt::format("'{}' has no meaning for {}; allowed: {}", word, owner,
                                          fmt::join(allowed, ", ")));
        }
    }
    return given;
}

CaseSection CaseSection::section(const std::string& name) const {
    return CaseSection(
        std::make_unique<Implementation>(Implementation{implementation_->value(name)}));
}

std::vector<CaseSection> CaseSection::list(const std::string& name) const {
    return implementation_->values(name, [](const LocatedNode& p) {
        return CaseSection(std::make_unique<Implementation>(Implementation{p}));
    });
}

InputError CaseSection::error(const std::string& name, const std::string& message) const {
    const LocatedNode place =
        name.empty() ? implementation_->place : implementation_->place.child(name);
    return place.node.IsDefined() ? place.error(message)
                                  : implementation_->place.error(name + ": " + message);
}

} // namespace tokay::structure
