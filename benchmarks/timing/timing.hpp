// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace tokay::benchmarks {

/// On the wall, and of the processors, which others that use them disturb less.
struct Seconds {
    double wall = std::numeric_limits<double>::infinity();
    double processor = std::numeric_limits<double>::infinity();
};

template <class Work>
Seconds secondsOf(Work work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processorStart = std::clock();
    work();
    const auto end = std::chrono::steady_clock::now();
    return {std::chrono::duration<double>(end - start).count(),
            static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC};
}

/// Best of a few times.
template <class Work>
Seconds bestSeconds(int nTimes, Work work) {
    Seconds best;
    for (int k = 0; k < nTimes; ++k) {
        const Seconds seconds = secondsOf(work);
        best.wall = std::min(best.wall, seconds.wall);
        best.processor = std::min(best.processor, seconds.processor);
    }
    return best;
}

/// Of a dense product of the linked BLAS, a core [GFlop/s].
double productRate();

/// Threads of the BLAS, if it is OpenBLAS.
void setBlasThreads(int nThreads);

} // namespace tokay::benchmarks
