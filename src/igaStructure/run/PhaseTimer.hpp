// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <utility>

namespace tokay::structure {

/// Phases of a time step, for timing.
enum class Phase { waiting, mapping, solving, acceleration, output };

/// Seconds of each phase since the last reset. Phases may be nested: a second counts
/// for the innermost one.
class PhaseTimer {
  public:
    static constexpr int nPhases = 5;

    /// The phase from its construction to its end.
    class Scope {
      public:
        Scope(PhaseTimer& timer, Phase phase) : timer_(timer), outer_(timer.change(phase)) {}
        ~Scope() { timer_.change(outer_); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PhaseTimer& timer_;
        std::optional<Phase> outer_;
    };

    [[nodiscard]] Scope enter(Phase phase) { return {*this, phase}; }

    /// Runs work() within the phase.
    template <class Work>
    auto time(Phase phase, Work work) {
        const Scope scope(*this, phase);
        return work();
    }

    void add(Phase phase, double seconds) { seconds_[static_cast<int>(phase)] += seconds; }
    double seconds(Phase phase) const { return seconds_[static_cast<int>(phase)]; }
    void reset() { seconds_.fill(0); }

  private:
    using Clock = std::chrono::steady_clock;

    /// @return  the phase until now
    std::optional<Phase> change(std::optional<Phase> phase) {
        const Clock::time_point now = Clock::now();
        if (phase_) {
            add(*phase_, std::chrono::duration<double>(now - since_).count());
        }
        since_ = now;
        return std::exchange(phase_, phase);
    }

    std::array<double, nPhases> seconds_ = {};
    std::optional<Phase> phase_; ///< none: not timed
    Clock::time_point since_;
};

} // namespace tokay::structure
