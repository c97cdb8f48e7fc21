// SPDX-License-Identifier: GPL-3.0-or-later
#include "Table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tokay::benchmark {

Table::Table(const std::string& path) : csv_(path) {
    if (!csv_) {
        throw std::runtime_error("cannot write " + path);
    }
    csv_ << "pair,operator,n,nFrom,nTo,build_s,apply_s,memory_MB,smoothError,smoothLargestError,"
            "shockError,shockOvershoot,forceSumError,momentError\n";
    fmt::print("{:<26} {:<20} {:>5} {:>6} {:>6} {:>8} {:>8} {:>7} {:>8} {:>8} {:>8} {:>8} {:>8} "
               "{:>8}\n",
               "pair", "operator", "n", "from", "to", "build/s", "apply/s", "MB", "smooth",
               "largest", "shock", "over", "force", "moment");
}

void Table::add(const Row& row) {
    csv_ << fmt::format("{},{},{},{},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.1e},"
                        "{:.1e}\n",
                        row.pair, row.method, row.n, row.nFrom, row.nTo, row.buildSeconds,
                        row.applySeconds, row.megabytes, row.smoothMean, row.smoothLargest,
                        row.shockMean, row.shockOvershoot, row.forceSumError, row.momentError);
    csv_.flush();
    fmt::print("{:<26} {:<20} {:>5} {:>6} {:>6} {:>8.2g} {:>8.2g} {:>7.2g} {:>8.2g} {:>8.2g} "
               "{:>8.2g} {:>8.2g} {:>8.1e} {:>8.1e}\n",
               row.pair, row.method, row.n, row.nFrom, row.nTo, row.buildSeconds, row.applySeconds,
               row.megabytes, row.smoothMean, row.smoothLargest, row.shockMean, row.shockOvershoot,
               row.forceSumError, row.momentError);
    std::fflush(stdout);
    rows_.push_back(row);
}

bool Table::printOrders() const {
    fmt::print("\nOrder of the smooth field's error between the two largest sizes\n{:<26} {:<20} "
               "{:>6} {:>8} verdict\n",
               "pair", "operator", "order", "expected");
    bool good = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row* before = nullptr;
        bool isLast = true;
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            if (rows_[j].pair == rows_[i].pair && rows_[j].method == rows_[i].method) {
                before = j < i ? &rows_[j] : before;
                isLast = isLast && j <= i;
            }
        }
        if (!isLast || !before) {
            continue;
        }
        const Row& row = rows_[i];
        const double order = std::log(before->smoothMean / row.smoothMean) /
                             std::log(static_cast<double>(row.n) / before->n);
        // Meshes are uneven and meet by chance.
        const bool isMissed = row.expectedOrder > 0 && order < row.expectedOrder - 0.25;
        good = good && !isMissed;
        fmt::print("{:<26} {:<20} {:>6.2f} {:>8} {}\n", row.pair, row.method, order,
                   row.expectedOrder > 0 ? fmt::format("{:g}", row.expectedOrder) : "",
                   row.expectedOrder == 0 ? ""
                   : isMissed             ? "MISSED"
                                          : "ok");
    }
    return good;
}

} // namespace tokay::benchmark
