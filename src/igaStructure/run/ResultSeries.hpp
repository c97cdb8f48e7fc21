// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/output/pvd.hpp"

#include <optional>

namespace tokay::structure {

/// The deformed body at a series of times, for ParaView: a .vtu file a time
/// and a .pvd file that lists them, rewritten with each. Nothing is written
/// before the first result; it brings the state at the start with it.
class ResultSeries {
  public:
    /// @param body   is kept by reference
    /// @param name   of the .pvd file, begins the names of the .vtu files
    /// @param start  state at the start of the run
    /// @throws InputError for a field that the body does not have
    ResultSeries(const Body& body, const OutputOptions& options, std::string name,
                 const MotionState& start);

    /// Goes on with the series of an earlier run, without what it has after the
    /// start.
    void continueEarlier();

    /// @throws OutputError
    void add(const MotionState& state);

  private:
    void addFile(const MotionState& state);
    std::string pvdPath() const { return directory_ + "/" + name_ + ".pvd"; }

    const Body& body_;
    std::string directory_;
    std::vector<BodyField> fields_;
    std::string name_;
    std::vector<VtuMesh> meshes_;
    std::optional<MotionState> start_; ///< until written
    std::vector<PvdEntry> entries_;
};

} // namespace tokay::structure
