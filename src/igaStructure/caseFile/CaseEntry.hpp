// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tokay::structure {

/// What an entry of the case file holds.
enum class Kind {
    map,     ///< entries of its own
    mapList, ///< a list of maps
    number,  ///< finite
    integer,
    yesNo, ///< yes | no
    word,  ///< one of the allowed words
    text,
    formula, ///< a number or a formula in x, y, z, t
    numbers, ///< a list of numbers
    integers,
    words,
    formulas,
    points ///< a list of [x, y] or [x, y, z]
};

/// Whether an entry must be given.
enum class Presence { required, optional, defaulted };

/// One entry of the case file: all that the reader checks and the manual says.
struct CaseEntry {
    std::string path; ///< "material.density"; "loads[].edge" inside a list
    Kind kind = Kind::number;
    Presence presence = Presence::required;
    std::string fallback; ///< YAML text of the default, with Presence::defaulted
    std::string unit;     ///< empty: none
    std::string allowed;  ///< numbers: an interval "(0, inf)"; words: separated by blanks
    int count = 0;        ///< length of a list; 0: any but none
    std::string meaning;  ///< one sentence
};

/// The whole case file, parents before their children.
const std::vector<CaseEntry>& caseEntries();

/// The entry at a path, null if there is none.
const CaseEntry* findCaseEntry(const std::string& path);

/// Names of the entries directly inside the map at a path ("" is the file).
std::vector<std::string> childNames(const std::string& path);

/// The words of an `allowed` text.
std::vector<std::string> splitWords(const std::string& text);

/// The manual's tables of all entries (doc/caseFile.md), in Markdown.
std::string describeCaseEntries();

} // namespace tokay::structure
