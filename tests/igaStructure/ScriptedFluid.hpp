// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"
#include "channel/handshake/shakeHands.hpp"
#include "igaStructure/coupledRun/CoupledRun.hpp"

#include <sys/socket.h>

#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tokay::structure {

/// The fluid's interface around the example's flap: up the left edge, over the
/// top, down the right edge; a face between two points.
inline channel::Interface flapInterface(int facesAlongHeight) {
    channel::Interface fluid;
    fluid.dimension = 2;
    fluid.name = "structure";
    const auto addPoint = [&](double x, double y) {
        fluid.points.insert(fluid.points.end(), {x, y});
    };
    for (int i = 0; i <= facesAlongHeight; ++i) {
        addPoint(-0.05, static_cast<double>(i) / facesAlongHeight);
    }
    for (int i = facesAlongHeight; i >= 0; --i) {
        addPoint(0.05, static_cast<double>(i) / facesAlongHeight);
    }
    const auto nPoints = static_cast<std::uint32_t>(fluid.points.size() / 2);
    fluid.faceOffsets.push_back(0);
    for (std::uint32_t k = 0; k + 1 < nPoints; ++k) {
        fluid.facePoints.insert(fluid.facePoints.end(), {k, k + 1});
        fluid.faceOffsets.push_back(static_cast<std::uint32_t>(fluid.facePoints.size()));
    }
    fluid.displacements.assign(fluid.points.size(), 0);
    fluid.tolerance = 1e-6;
    fluid.endTime = 0.1;
    return fluid;
}

/// Force along x on the faces of the left edge, its sum given [N/m].
inline std::vector<double> forceOnLeft(const channel::Interface& fluid, double sum) {
    const std::size_t nFaces = fluid.faceOffsets.size() - 1;
    const std::size_t nLeft = (nFaces - 1) / 2;
    std::vector<double> values(2 * nFaces, 0);
    for (std::size_t face = 0; face < nLeft; ++face) {
        values[2 * face] = sum / static_cast<double>(nLeft);
    }
    return values;
}

/// A fluid played by a test, with igaStructure's coupled run in a thread at
/// the other end of a socket pair.
class ScriptedFluid {
  public:
    explicit ScriptedFluid(const std::string& caseFile, const CoupledRunOptions& options = {})
        : channel_(connectToNewStructure(caseFile, options)) {
        channel::Hello hello;
        hello.role = channel::Role::fluid;
        hello.program = "scripted fluid";
        channel::shakeHands(*channel_, hello);
    }
    ~ScriptedFluid() {
        channel_.reset();
        if (thread_.joinable()) {
            thread_.join();
        }
    }

    channel::Channel& channel() { return *channel_; }

    std::string start(const channel::Interface& fluid) {
        channel_->send(fluid);
        return channel_->receive<channel::Accepted>("accepted").report;
    }

    channel::Displacements begin(std::uint32_t step, double time, double deltaT) {
        channel_->send(channel::BeginStep{step, time, deltaT});
        return receive();
    }

    channel::Displacements exchange(const std::vector<double>& values, bool final = false,
                                    bool write = false) {
        channel_->send(channel::Forces{final, write, 0, values});
        return receive();
    }

    channel::Displacements receive() {
        return channel_->receive<channel::Displacements>("displacements");
    }

    /// A step with the same forces in every exchange.
    /// @return  exchanges before the final one
    int advance(std::uint32_t step, double deltaT, const std::vector<double>& values,
                bool write = false) {
        begin(step, step * deltaT, deltaT);
        int nExchanges = 1;
        while (exchange(values).state != channel::State::converged) {
            if (++nExchanges > 50) {
                throw std::runtime_error("the structure does not converge");
            }
        }
        exchange(values, true, write);
        return nExchanges;
    }

    void sayGoodbye() { channel_->send(channel::Goodbye{"end of the script"}); }

    /// Vanishes without a word.
    void vanish() { channel_.reset(); }

    /// Waits for the structure's end.
    /// @return  its exception's text; empty if it ended in good order
    std::string outcome() {
        thread_.join();
        return outcome_;
    }

    std::string log() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return log_;
    }

    /// The text that the structure's failure brings to the fluid.
    std::string failureText() {
        try {
            channel_->receive("a failure");
        } catch (const channel::PeerFailure& failure) {
            return failure.what();
        }
        return "no failure";
    }

  private:
    channel::Channel connectToNewStructure(const std::string& caseFile,
                                           const CoupledRunOptions& options) {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
            throw std::runtime_error("no socket pair");
        }
        thread_ = std::thread([this, caseFile, options, end = ends[1]] {
            try {
                runCoupled(caseFile, channel::Channel::fromFileDescriptor(end), options,
                           [this](const std::string& text) {
                               const std::lock_guard<std::mutex> lock(mutex_);
                               log_ += text + "\n";
                           });
            } catch (const std::exception& error) {
                outcome_ = error.what();
            }
        });
        return channel::Channel::fromFileDescriptor(ends[0]);
    }

    std::thread thread_;
    std::mutex mutex_;
    std::string log_;
    std::string outcome_;
    std::optional<channel::Channel> channel_;
};

} // namespace tokay::structure
