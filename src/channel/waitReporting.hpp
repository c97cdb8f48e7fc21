// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <asio/io_context.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>

namespace tokay::channel {

/// How, and how often, to say that the peer is silent.
struct SilenceReport {
    double intervalSeconds = 0; ///< 0: never
    std::function<void(const std::string&)> report;
};

/// "waiting for the fluid's forces since 60 s, step 12"
inline std::string silenceText(const std::string& waitingFor, double seconds) {
    const std::size_t comma = std::min(waitingFor.find(','), waitingFor.size());
    return "waiting for " + waitingFor.substr(0, comma) + " since " +
           std::to_string(std::lround(seconds)) + " s" + waitingFor.substr(comma);
}

/// Runs the context until `done` holds, reporting each interval of silence.
template <class Done>
void waitReporting(asio::io_context& context, const SilenceReport& silence,
                   const std::string& waitingFor, Done done) {
    using Seconds = std::chrono::duration<double>;
    const auto start = std::chrono::steady_clock::now();
    context.restart();
    while (!done()) {
        if (silence.intervalSeconds <= 0) {
            context.run_one();
            continue;
        }
        const auto interval = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
            Seconds(silence.intervalSeconds));
        if (context.run_one_for(interval) == 0 && !done()) {
            const Seconds waited = std::chrono::steady_clock::now() - start;
            silence.report(silenceText(waitingFor, waited.count()));
            context.restart();
        }
    }
}

} // namespace tokay::channel
