// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/OutputFile.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Writes the interface displacement of each accepted step, for a later run
/// with prescribed motion. Text: a line a step, time, displacements, and the
/// checksum of the file so far.
class DisplacementRecorder {
  public:
    /// @param startTime  steps of an earlier run's file until then are kept [s]
    DisplacementRecorder(std::string path, double startTime)
        : path_(std::move(path)), startTime_(startTime) {}

    /// @throws OutputError
    void add(double time, const Eigen::VectorXd& displacements);

  private:
    void open();
    void write(const std::string& numbers);

    std::string path_;
    double startTime_;
    std::uint32_t checksum_ = 0; ///< of the lines written
    std::optional<OutputFile> file_;
};

/// Reads such a file.
class DisplacementRecord {
  public:
    /// @param nValues  that each step must have
    /// @throws InputError: file, line, what does not fit
    DisplacementRecord(const std::string& path, Eigen::Index nValues);

    /// Displacements at a time, between recorded ones interpolated linearly.
    /// @throws InputError after the last recorded time
    Eigen::VectorXd at(double time) const;

  private:
    std::string path_;
    std::vector<double> times_;
    std::vector<Eigen::VectorXd> displacements_;
};

} // namespace tokay::structure
