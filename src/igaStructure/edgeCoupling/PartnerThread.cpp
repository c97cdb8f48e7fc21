// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/edgeCoupling/PartnerThread.hpp"

#include "common/errors.hpp"
#include "igaStructure/coupledRun/CoupledRun.hpp"

#include <sys/socket.h>

#include <utility>

namespace tokay::structure {

PartnerThread::PartnerThread(const std::string& caseFile, Report report) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        throw SolverError("the system gives no socket pair to couple two structures");
    }
    end_ = ends[0];
    thread_ = std::thread([caseFile, report = std::move(report), end = ends[1]] {
        try {
            runCoupled(caseFile, channel::Channel::fromFileDescriptor(end), {}, report);
        } catch (const std::exception&) {
            // the other side has been told
        }
    });
}

} // namespace tokay::structure
