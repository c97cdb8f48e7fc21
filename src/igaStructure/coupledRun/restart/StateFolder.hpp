// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/coupledRun/restart/SavedState.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// The saved states of a case, a file a time, beside its results.
class StateFolder {
  public:
    /// @param name  of the case, begins the names of the files
    StateFolder(std::string directory, std::string name)
        : directory_(std::move(directory)), name_(std::move(name)) {}

    /// Replaces an older state of the same time, whole or not at all.
    /// @param deltaT  of the step that ends there [s]
    /// @throws OutputError
    void add(const SavedState& state, double deltaT);

    /// Of the states added here, removes those that no restart would take any more:
    /// all but the last, and but the nearest one of each time of the fluid.
    /// @param fluidTimes  that the fluid has on disk [s]
    void removeExcept(const std::vector<double>& fluidTimes);

    /// The state nearest to a time, if one is within the tolerance [s].
    /// @throws InputError if its file is damaged
    std::optional<SavedState> find(double time, double tolerance) const;

    /// Times as the files are named, ascending [s].
    std::vector<double> times() const;

    const std::string& directory() const { return directory_; }

  private:
    struct Added {
        double time;
        double deltaT;
    };
    std::string path(double time) const;

    std::string directory_;
    std::string name_;
    std::vector<Added> added_; ///< in this run
};

} // namespace tokay::structure
