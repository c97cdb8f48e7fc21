// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <fstream>
#include <string>

namespace tokay::channel {

/// Text file of all that passes between fluid and structure, one line each:
///   dimension N | points ... | faceOffsets ... | facePoints ... |
///   displacements ... | tolerance T | times START END
///   step NUMBER TIME DELTAT
///   forces TIME FINAL WRITE RESIDUAL ...
///   answer TIME STATE ...
///   rejected TIME REASON
class Record {
  public:
    /// @param fileName  empty: nothing is recorded
    explicit Record(const std::string& fileName);

    void add(const Interface& interface);
    void add(const BeginStep& step);
    void add(const Forces& forces);
    void add(const Displacements& answer);
    void add(const RejectStep& rejection);

  private:
    template <class Values>
    void row(const std::string& name, const Values& values);

    std::ofstream file_;
    double time_ = 0;
};

} // namespace tokay::channel
