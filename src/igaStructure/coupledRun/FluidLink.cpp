// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/FluidLink.hpp"

#include "channel/handshake/shakeHands.hpp"
#include "igaStructure/run/Interruption.hpp"

namespace tokay::structure {

namespace {

// How long a signal may go unnoticed while waiting [s].
constexpr double pollInterval = 0.2;

} // namespace

FluidLink::FluidLink(channel::Channel channel, double silenceInterval, Report report)
    : channel_(std::move(channel)), silenceInterval_(silenceInterval), report_(std::move(report)) {
    channel_.reportSilence(pollInterval, [this](const std::string& text) { onSilence(text); });
    beginWaiting();
}

void FluidLink::shakeHands(const channel::Hello& own) {
    if (!channel_.isTrusted()) {
        channel::shakeHands(channel_, own);
    }
}

void FluidLink::send(const channel::Message& message) {
    throwIfInterrupted();
    beginWaiting();
    channel_.send(message);
}

channel::Message FluidLink::receive(const std::string& waitingFor) {
    beginWaiting();
    return channel_.receive(waitingFor);
}

void FluidLink::tellFailure(const std::string& text) noexcept {
    if (!toldFailure_) {
        toldFailure_ = true;
        channel_.trySend(channel::Failure{text});
    }
}

void FluidLink::beginWaiting() {
    nextReport_ = std::chrono::steady_clock::now() +
                  std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                      std::chrono::duration<double>(silenceInterval_));
}

void FluidLink::onSilence(const std::string& text) {
    try {
        throwIfInterrupted();
    } catch (const Interrupted& interrupted) {
        tellFailure(interrupted.what()); // an exception from here closes the channel
        throw;
    }
    if (std::chrono::steady_clock::now() >= nextReport_) {
        beginWaiting();
        report_(text);
    }
}

} // namespace tokay::structure
