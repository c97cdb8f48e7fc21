// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/CoupledRun.hpp"

#include "channel/PeerError.hpp"
#include "common/errors.hpp"
#include "common/version.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/coupledRun/CoupledSession.hpp"
#include "igaStructure/coupledRun/FluidLink.hpp"

namespace tokay::structure {

Case readCoupledCase(const std::string& caseFile) {
    Case structureCase = readCase(caseFile);
    if (!structureCase.coupling) {
        throw InputError(structureCase.file + ": entry 'coupling' is missing: a coupled run "
                                              "needs it (coupling: {interface: [edges]})");
    }
    if (!structureCase.implicitScheme()) {
        throw InputError(structureCase.file + ": time.scheme: arcLength and explicit are for a run "
                                              "alone; choose another scheme for a coupled one");
    }
    return structureCase;
}

Case readLoadedCase(const std::string& caseFile) {
    Case structureCase = readCoupledCase(caseFile);
    if (structureCase.coupling->side == CouplingSide::dirichlet) {
        throw structureCase.coupling->error(
            "side", "dirichlet: another structure moves this one, which leads: start both by "
                    "igaStructure couple; beside a fluid the side is neumann");
    }
    return structureCase;
}

channel::Hello structureGreeting() {
    channel::Hello hello;
    hello.role = channel::Role::structure;
    hello.program = std::string("igaStructure ") + version;
    return hello;
}

void runCoupled(const std::string& caseFile, channel::Channel channel,
                const CoupledRunOptions& options, const Report& report) {
    FluidLink link(std::move(channel), options.silenceInterval, report);
    try {
        link.shakeHands(structureGreeting());
        const Case structureCase = readLoadedCase(caseFile);
        CoupledSession(structureCase, link, options, report).run();
    } catch (const channel::PeerFailure&) {
        throw; // it has ended already
    } catch (const std::exception& error) {
        link.tellFailure(error.what());
        throw;
    }
}

} // namespace tokay::structure
