// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"
#include "igaStructure/run/StepReport.hpp"

#include <chrono>

namespace tokay::structure {

/// The channel to the fluid, which a signal to this process can interrupt.
class FluidLink {
  public:
    /// @param silenceInterval  a silent fluid is reported this often [s]
    FluidLink(channel::Channel channel, double silenceInterval, Report report);
    FluidLink(const FluidLink&) = delete;
    FluidLink& operator=(const FluidLink&) = delete;

    /// Unless the channel is trusted already.
    void shakeHands(const channel::Hello& own);

    /// "the fluid", or what else has its part.
    const std::string& peer() const { return channel_.peer(); }

    /// As those of Channel. @throws also Interrupted
    void send(const channel::Message& message);
    channel::Message receive(const std::string& waitingFor);
    template <class Expected>
    Expected receive(const std::string& waitingFor) {
        beginWaiting();
        return channel_.receive<Expected>(waitingFor);
    }

    /// Tells the fluid why the run cannot go on; never throws.
    void tellFailure(const std::string& text) noexcept;

  private:
    void beginWaiting();
    void onSilence(const std::string& text);

    channel::Channel channel_;
    double silenceInterval_;
    Report report_;
    std::chrono::steady_clock::time_point nextReport_;
    bool toldFailure_ = false;
};

} // namespace tokay::structure
