// SPDX-License-Identifier: GPL-3.0-or-later
// What each mapping operator costs and how accurate it is: discretisation pairs
// x operators x sizes, a smooth field and a shock.
// Usage: operators RESULTS.csv [quick]
#include "Table.hpp"
#include "interfaces.hpp"
#include "pairs.hpp"

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace tokay::benchmark;
    try {
        Table table(argc > 1 ? argv[1] : "results.csv");
        const bool quick = argc > 2;
        for (const Pair& pair : pairs()) {
            for (const int n : quick ? pair.quickSizes : pair.sizes) {
                measure(pair, n, table);
            }
        }
        return table.printOrders() ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
