#pragma once

#include "common/errors.hpp"
#include "igaStructure/caseFile/Formula.hpp"

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

    CaseSection section(const std::string& name) const;
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
