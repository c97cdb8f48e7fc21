// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/run/StepReport.hpp"

#include <string>

namespace tokay::structure {

/// Keeps other runs from writing the results of a case at the same time: a file
/// <case>.lock beside them that the system locks, with process and host of who
/// holds it. The lock ends with the process however that ends; a file that a killed
/// run has left is reported and taken over.
class ResultsLock {
  public:
    /// Creates the folder too.
    /// @throws InputError that names the run which holds the lock, OutputError
    ResultsLock(const std::string& directory, const std::string& name, const Report& report);

    /// Removes the file, and the folder if nothing else is in it.
    ~ResultsLock();
    ResultsLock(const ResultsLock&) = delete;
    ResultsLock& operator=(const ResultsLock&) = delete;

  private:
    void open();
    bool tryToLock();
    bool isStillThere() const;
    void lock(const Report& report);
    std::string holder() const;
    void writeHolder();

    std::string directory_;
    std::string path_;
    int file_ = -1;
};

} // namespace tokay::structure
