// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"
#include "igaStructure/run/StepReport.hpp"

#include <string>
#include <thread>

namespace tokay::structure {

/// The other structure of a pair in a thread of this process, at the other end of a
/// socket pair: what it would be in a process of its own. Its end is waited for.
class PartnerThread {
  public:
    /// @param caseFile  of a coupled run
    /// @throws SolverError if the system has no socket pair
    PartnerThread(const std::string& caseFile, Report report);
    ~PartnerThread() { thread_.join(); }
    PartnerThread(const PartnerThread&) = delete;
    PartnerThread& operator=(const PartnerThread&) = delete;

    /// This side's end, once.
    channel::Channel takeChannel() { return channel::Channel::fromFileDescriptor(end_); }

  private:
    int end_ = -1;
    std::thread thread_;
};

} // namespace tokay::structure
