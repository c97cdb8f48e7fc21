// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/Interruption.hpp"

#include <csignal>
#include <cstring>

namespace tokay::structure {

namespace {

volatile std::sig_atomic_t arrivedSignal = 0;

extern "C" void rememberSignal(int signal) {
    arrivedSignal = signal;
}

} // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(std::string("interrupted by signal ") + std::to_string(signal) + " (" +
                         strsignal(signal) + ")"),
      signal_(signal) {}

void rememberSignals() {
    struct sigaction action = {};
    action.sa_handler = rememberSignal;
    // A second signal ends the process at once, should it not react to the first.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void throwIfInterrupted() {
    if (arrivedSignal != 0) {
        const int signal = arrivedSignal;
        arrivedSignal = 0;
        throw Interrupted(signal);
    }
}

} // namespace tokay::structure
