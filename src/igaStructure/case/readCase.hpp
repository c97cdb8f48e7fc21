// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"

#include <string>

namespace tokay::structure {

/// Reads a case file.
/// @throws InputError for the first mistake: file, line, entry, what to change
Case readCase(const std::string& fileName);

/// Reads the text of a case file.
/// @param fileName  for messages, and to find other files
Case readCaseText(const std::string& text, const std::string& fileName);

/// The manual's tables of all entries (doc/caseFile.md), in Markdown.
std::string describeCaseEntries();

} // namespace tokay::structure
