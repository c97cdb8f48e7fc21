// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace tokay {

/// What a function of time gives, kept for the time that was asked for last: every solution
/// of a time step asks where supports are, and a formula at all of their points is dear.
template <class Value>
class LatestValue {
  public:
    /// @param evaluate  gives the value at this time; called if the time is another one
    template <class Evaluate>
    const Value& at(double time, Evaluate evaluate) {
        if (time_ != time) {
            value_ = evaluate();
            time_ = time;
        }
        return value_;
    }

  private:
    std::optional<double> time_;
    Value value_;
};

} // namespace tokay
