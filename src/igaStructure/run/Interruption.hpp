// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace tokay::structure {

/// The user, or the system, asked the program to end.
class Interrupted : public std::runtime_error {
  public:
    explicit Interrupted(int signal);
    int signal() const { return signal_; }

  private:
    int signal_;
};

/// From now on SIGINT and SIGTERM are remembered instead of ending the process.
void rememberSignals();

/// @throws Interrupted if such a signal has arrived
void throwIfInterrupted();

} // namespace tokay::structure
