// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>

namespace tokay::structure {

/// Phases of a time step, for timing.
enum class Phase { waiting, mapping, solving, acceleration, output };

/// Seconds of each phase since the last reset.
class PhaseTimer {
  public:
    static constexpr int nPhases = 5;

    /// Runs work() and adds its duration to the phase.
    template <class Work>
    auto time(Phase phase, Work work) {
        const Adder adder{seconds_[static_cast<int>(phase)]};
        return work();
    }

    void add(Phase phase, double seconds) { seconds_[static_cast<int>(phase)] += seconds; }
    double seconds(Phase phase) const { return seconds_[static_cast<int>(phase)]; }
    void reset() { seconds_.fill(0); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Adder {
        double& seconds;
        Clock::time_point start = Clock::now();
        ~Adder() { seconds += std::chrono::duration<double>(Clock::now() - start).count(); }
    };

    std::array<double, nPhases> seconds_ = {};
};

} // namespace tokay::structure
