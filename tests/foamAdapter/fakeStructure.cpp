// SPDX-License-Identifier: GPL-3.0-or-later
// A structure that does as it is told: the other side of the adapter's tests.
//
// fakeStructure run CASE [--behaviour NAME] [--record FILE]
//               (--channel-fd N | --listen ADDRESS [--token TEXT])
//   CASE is not read. Unless the behaviour says otherwise every answer is a
//   rigid interface that has converged.

#include "Record.hpp"
#include "channel/handshake/Listener.hpp"
#include "channel/handshake/shakeHands.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace tokay::channel;

struct Options {
    std::string behaviour = "rigid";
    std::string recordFile;
    std::string address; ///< to listen at, in place of the channel
    std::string token;
    int channel = -1;
};

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i + 1 < argc; ++i) {
        const std::string key = argv[i];
        if (key == "--behaviour") {
            options.behaviour = argv[++i];
        } else if (key == "--record") {
            options.recordFile = argv[++i];
        } else if (key == "--listen") {
            options.address = argv[++i];
        } else if (key == "--token") {
            options.token = argv[++i];
        } else if (key == "--channel-fd") {
            options.channel = std::stoi(argv[++i]);
        }
    }
    return options;
}

Hello greeting(const Options& options) {
    Hello own;
    own.role = Role::structure;
    own.program = "fakeStructure";
    if (options.behaviour == "otherVersion") {
        own.protocol = protocolVersion + 1;
    }
    return own;
}

/// A channel after the handshake.
Channel openChannel(const Options& options) {
    if (options.address.empty()) {
        Channel channel = Channel::fromFileDescriptor(options.channel);
        shakeHands(channel, greeting(options));
        return channel;
    }
    Listener listener(options.address, options.token);
    std::cout << "listening at " << listener.address() << std::endl;
    return listener.accept(greeting(options));
}

void writeRaw(int fileDescriptor, const std::vector<unsigned char>& bytes) {
    if (write(fileDescriptor, bytes.data(), bytes.size()) < 0) {
        std::perror("fakeStructure");
    }
}

/// What is not a message, or not all of one.
bool sendNonsense(const Options& options) {
    if (options.behaviour == "garbage") {
        writeRaw(options.channel, std::vector<unsigned char>(64, 0xAB));
    } else if (options.behaviour == "truncated") {
        writeRaw(options.channel, {'T', 'o', 'k'});
    } else if (options.behaviour == "oversized") {
        // A frame header as ours, with the largest possible payload
        std::vector<unsigned char> header{'T', 'o', 'k', 'a', protocolVersion, 0, 0, 0, 5, 0, 0, 0};
        header.insert(header.end(), 4, 0xFF);
        writeRaw(options.channel, header);
    } else {
        return false;
    }
    return true;
}

class Structure {
  public:
    explicit Structure(const Options& options)
        : options_(options), channel_(openChannel(options)), record_(options.recordFile) {}

    int run() {
        interface_ = channel_.receive<Interface>("the interface");
        record_.add(interface_);
        if (behaves("refuse")) {
            channel_.send(Failure{"this interface is not mine"});
            return 1;
        }
        const std::string escape = behaves("escapes") ? "\x1b[2J\x07" : "";
        channel_.send(Accepted{"fakeStructure, " + options_.behaviour + escape, false});
        return converse();
    }

  private:
    bool behaves(const char* behaviour) const { return options_.behaviour == behaviour; }

    int converse() {
        for (;;) {
            const Message message = channel_.receive("the fluid's next message");
            if (const auto* step = std::get_if<BeginStep>(&message)) {
                record_.add(*step);
                time_ = step->time;
                deltaT_ = step->deltaT;
                exchange_ = nFinals_ = 0;
                answer(State::iterate);
            } else if (const auto* forces = std::get_if<Forces>(&message)) {
                record_.add(*forces);
                ++exchange_;
                nFinals_ += forces->final;
                misbehave();
                answer(stateAfter(*forces));
            } else if (const auto* rejection = std::get_if<RejectStep>(&message)) {
                record_.add(*rejection);
            } else if (const auto* goodbye = std::get_if<Goodbye>(&message)) {
                std::cout << "goodbye: " << goodbye->reason << std::endl;
                return end();
            }
        }
    }

    State stateAfter(const Forces& forces) const {
        if (cannotSolve(forces)) {
            return State::rejected;
        }
        if (forces.final) {
            const bool asks = (behaves("asksOnce") && nFinals_ == 1) || behaves("asksForever");
            return asks && forces.ifConverged ? State::iterate : State::accepted;
        }
        const bool iterates = behaves("neverConverges") || (behaves("rejects") && exchange_ < 4) ||
                              (behaves("convergesShort") && (deltaT_ > 0.006 || exchange_ < 4)) ||
                              (behaves("creeps") && exchange_ < 4);
        return iterates ? State::iterate : State::converged;
    }

    /// Steps longer than 0.006 s have no solution, as the second or the last
    /// exchange shows; or those longer than 0.003 s that begin at 0.01 s.
    bool cannotSolve(const Forces& forces) const {
        if (behaves("failsOnce")) {
            return std::abs(time_ - deltaT_ - 0.01) < 1e-6 && deltaT_ > 0.003;
        }
        return deltaT_ > 0.006 &&
               ((behaves("rejects") && exchange_ == 2) || (behaves("rejectsLast") && forces.final));
    }

    void answer(State state) {
        Displacements displacements;
        displacements.state = state;
        displacements.residual = state == State::iterate ? 1 : 0;
        displacements.values.assign(interface_.points.size(), 0.0);
        if (state == State::rejected) {
            displacements.values.clear();
            displacements.reason = "no solution, as told";
        }
        if (behaves("sway") || behaves("creeps") || behaves("rejects") || behaves("rejectsLast") ||
            behaves("convergesShort") || behaves("leaps")) {
            sway(displacements.values);
        }
        if (behaves("nan") && exchange_ > 0) {
            displacements.values.back() = std::numeric_limits<double>::quiet_NaN();
        }
        if (behaves("tooFew")) {
            displacements.values.pop_back();
        }
        lie(displacements);
        record_.add(displacements);
        channel_.send(displacements);
    }

    /// What no structure can mean.
    void lie(Displacements& displacements) const {
        const bool isAnswer = exchange_ > 0;
        if (behaves("convergedFar") && displacements.state == State::converged) {
            displacements.residual = 1e5;
        } else if (behaves("residualNan") && isAnswer) {
            displacements.residual = std::numeric_limits<double>::quiet_NaN();
        } else if (behaves("acceptsEarly") && isAnswer) {
            displacements.state = State::accepted;
        } else if (behaves("rejectsPrediction") || (behaves("rejectsSilently") && isAnswer)) {
            displacements.state = State::rejected;
            displacements.values.clear();
        }
    }

    /// Shear in x, proportional to y, in space to y z; with "creeps" each
    /// exchange of a step adds to it, the last one too; with "leaps" steps longer
    /// than 0.006 s end far away.
    void sway(std::vector<double>& values) const {
        const double amplitude =
            0.05 * std::sin(20 * time_) * (behaves("creeps") ? 1 - std::pow(0.5, exchange_) : 1) +
            (behaves("leaps") && deltaT_ > 0.006 ? 5 : 0);
        for (std::size_t i = 0; i < values.size(); i += interface_.dimension) {
            const double z = interface_.dimension == 3 ? interface_.points[i + 2] : 1;
            values[i] = amplitude * interface_.points[i + 1] * z;
        }
    }

    void misbehave() const {
        if (sendNonsense(options_)) {
            std::exit(0);
        }
        if (behaves("dies")) {
            std::raise(SIGKILL);
        }
        if (behaves("silent") && time_ < 0.015 && exchange_ == 1) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        }
    }

    int end() {
        channel_.send(Goodbye{"as told"});
        if (behaves("stays")) {
            std::this_thread::sleep_for(std::chrono::hours(1));
        }
        return behaves("failsAtEnd") ? 3 : 0;
    }

    Options options_;
    Channel channel_;
    Record record_;
    Interface interface_;
    double time_ = 0;
    double deltaT_ = 0;
    int exchange_ = 0;
    int nFinals_ = 0; ///< final forces of this step
};

} // namespace

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    try {
        return Structure(options).run();
    } catch (const std::exception& error) {
        std::cerr << "fakeStructure: " << error.what() << '\n';
        return 2;
    }
}
