// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/JsonObject.hpp"
#include "mapper/Mapping.hpp"
#include "tokayMap/Source.hpp"

namespace tokay::tool {

/// Report of a mapping between two files, for a person and for programs.
class MapReport {
  public:
    MapReport(const Side& from, const Side& to, const mapper::MappingReport& mapping);

    void addRanges(const Source& from, const Eigen::MatrixXd& result);
    void addSums(const Source& from, const Eigen::MatrixXd& result);

    /// Difference of samples and a function, over its largest value there.
    /// @param formula  what the function is called
    void addError(const Eigen::VectorXd& samples, const Points& points,
                  const ScalarFunction& function, const std::string& formula);

    const std::string& text() const { return text_; }
    std::string json() const { return json_.text() + "\n"; }

  private:
    std::string text_;
    JsonObject json_;
};

} // namespace tokay::tool
