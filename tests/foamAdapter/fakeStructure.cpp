// A structure that does as it is told: the other side of the adapter's tests.
//
// fakeStructure run CASE --behaviour NAME [--record FILE] --channel-fd N
//   CASE is not read. Unless the behaviour says otherwise every answer is a
//   rigid interface, or a prescribed sway, that has converged.

#include "coupling/Channel.hpp"
#include "coupling/shakeHands.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <numeric>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

using namespace tokay::coupling;

struct Options {
    std::string behaviour = "rigid";
    std::string recordFile; ///< gets the interface and the forces that arrive
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
        } else if (key == "--channel-fd") {
            options.channel = std::stoi(argv[++i]);
        }
    }
    return options;
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
        std::vector<unsigned char> header{'T', 'o', 'k', 'a', 1, 0, 0, 0, 5, 0, 0, 0};
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
        : options_(options), channel_(Channel::fromFileDescriptor(options.channel)) {}

    int run() {
        Hello own;
        own.role = Role::structure;
        own.program = "fakeStructure";
        if (options_.behaviour == "otherVersion") {
            own.protocol = protocolVersion + 1;
        }
        shakeHands(channel_, own);
        interface_ = channel_.receive<Interface>("the interface");
        record();
        if (options_.behaviour == "refuse") {
            channel_.send(Failure{"this interface is not mine"});
            return 1;
        }
        channel_.send(Accepted{"fakeStructure, " + options_.behaviour});
        return answer();
    }

  private:
    int answer() {
        for (;;) {
            const Message message = channel_.receive("the fluid");
            if (const auto* step = std::get_if<BeginStep>(&message)) {
                time_ = step->time;
                exchange_ = 0;
                channel_.send(displacements(State::iterate));
            } else if (const auto* forces = std::get_if<Forces>(&message)) {
                ++exchange_;
                record(*forces);
                misbehave();
                channel_.send(displacements(stateAfter(*forces)));
            } else if (std::get_if<Goodbye>(&message)) {
                channel_.send(Goodbye{"as told"});
                return options_.behaviour == "failsAtEnd" ? 3 : 0;
            }
        }
    }

    State stateAfter(const Forces& forces) const {
        if (forces.final) {
            return State::accepted;
        }
        return options_.behaviour == "neverConverges" ? State::iterate : State::converged;
    }

    Displacements displacements(State state) const {
        Displacements answer;
        answer.state = state;
        answer.residual = state == State::iterate ? 1 : 0;
        answer.values.assign(interface_.points.size(), 0.0);
        if (options_.behaviour == "sway") {
            // Shear in x, proportional to the second coordinate
            for (std::size_t i = 0; i < answer.values.size(); i += interface_.dimension) {
                answer.values[i] = 0.05 * std::sin(20 * time_) * interface_.points[i + 1];
            }
        }
        if (options_.behaviour == "nan" && exchange_ > 0) {
            answer.values.front() = std::numeric_limits<double>::quiet_NaN();
        }
        if (options_.behaviour == "tooFew") {
            answer.values.pop_back();
        }
        return answer;
    }

    void misbehave() const {
        if (sendNonsense(options_)) {
            std::exit(0);
        }
        if (options_.behaviour == "dies") {
            std::raise(SIGKILL);
        }
        if (options_.behaviour == "silent") {
            std::this_thread::sleep_for(std::chrono::seconds(4));
        }
    }

    void record() const {
        if (options_.recordFile.empty()) {
            return;
        }
        std::ofstream file(options_.recordFile);
        file.precision(12);
        const auto row = [&](const char* name, const auto& values) {
            file << name;
            for (const auto value : values) {
                file << ' ' << value;
            }
            file << '\n';
        };
        file << "dimension " << interface_.dimension << '\n';
        row("points", interface_.points);
        row("faceOffsets", interface_.faceOffsets);
        row("facePoints", interface_.facePoints);
        row("displacements", interface_.displacements);
        file << "tolerance " << interface_.tolerance << '\n';
    }

    void record(const Forces& forces) const {
        if (options_.recordFile.empty()) {
            return;
        }
        std::ofstream file(options_.recordFile, std::ios::app);
        file.precision(12);
        file << "forces " << time_ << ' ' << forces.final << ' ' << forces.write;
        for (const double value : forces.values) {
            file << ' ' << value;
        }
        file << '\n';
    }

    Options options_;
    Channel channel_;
    Interface interface_;
    double time_ = 0;
    int exchange_ = 0;
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
