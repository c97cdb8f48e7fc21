// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Formula.hpp"
#include "common/errors.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// A map of the case file that has passed validation: entries exist, have
/// their type and lie in their range, so reading them cannot fail; defaults
/// are filled in. What entries mean to each other is the reader's to check.
class CaseSection {
  public:
    /// Reads a case file and checks it against the table of entries.
    /// @throws InputError for the first mistake: file, line, column, entry,
    ///         what is wrong and what is allowed
    static CaseSection fromFile(const std::string& fileName);

    /// As fromFile.
    /// @param fileName  for messages
    static CaseSection fromText(const std::string& text, const std::string& fileName);

    CaseSection(const CaseSection&);
    CaseSection(CaseSection&&) noexcept;
    CaseSection& operator=(CaseSection&&) noexcept;
    ~CaseSection();

    /// Whether the file gives the entry; defaults do not count.
    bool has(const std::string& name) const;

    /// Names of the entries that the file gives.
    std::vector<std::string> givenNames() const;

    /// Demands an entry that only some kinematics or shapes need.
    /// @param reason  ends the message
    /// @throws InputError if the file does not give it
    void require(const std::string& name, const std::string& reason) const;

    /// The one of the names that the file gives.
    /// @throws InputError if it gives none of them, or several, or another entry
    std::string exactlyOne(const std::vector<std::string>& names) const;

    double number(const std::string& name) const;
    int integer(const std::string& name) const;
    bool yesNo(const std::string& name) const;
    std::string text(const std::string& name) const;
    Formula formula(const std::string& name) const;
    std::vector<double> numbers(const std::string& name) const;
    std::vector<int> integers(const std::string& name) const;
    std::vector<std::string> words(const std::string& name) const;
    std::vector<Formula> formulas(const std::string& name) const;
    std::vector<std::vector<double>> points(const std::string& name) const;

    /// Lists of which a length is wanted that depends on other entries.
    /// @throws InputError if the list has another one
    std::vector<double> numbers(const std::string& name, std::size_t count) const;
    std::vector<int> integers(const std::string& name, std::size_t count) const;
    std::vector<Formula> formulas(const std::string& name, std::size_t count) const;

    /// @param allowed  of the words of the table, those that
    /// @param owner    has: "a beam"
    /// @throws InputError for another one
    std::vector<std::string> words(const std::string& name, const std::vector<std::string>& allowed,
                                   const std::string& owner) const;

    CaseSection section(const std::string& name) const;

    /// Of the entries that the file gives, whatever their layout.
    std::string digest() const;
    std::vector<CaseSection> list(const std::string& name) const;

    /// A mistake found by the reader.
    /// @param name  the entry that it concerns; empty: this map itself
    InputError error(const std::string& name, const std::string& message) const;

  private:
    struct Implementation;
    explicit CaseSection(std::unique_ptr<Implementation>);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::structure
