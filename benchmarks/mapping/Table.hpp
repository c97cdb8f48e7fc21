// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace tokay::benchmark {

/// What an operator cost and how far its result is from the field.
struct Row {
    std::string pair, method;
    int n, nFrom, nTo;
    double buildSeconds, applySeconds, megabytes;
    /// Root mean square and largest error at the samples.
    double smoothMean, smoothLargest;
    /// Root mean square error, and how far the result leaves the range 0 to 1.
    double shockMean, shockOvershoot;
    double forceSumError, momentError;
    /// Of the smooth field's error, that theory gives; 0: none.
    double expectedOrder;
};

/// Prints rows as they come, writes them as CSV, and knows the orders.
class Table {
  public:
    /// @throws std::runtime_error if the file cannot be written
    explicit Table(const std::string& path);

    void add(const Row& row);

    /// A line for each pair and operator: the order between the two largest
    /// sizes, and a verdict where theory gives one.
    /// @return whether no order was missed
    bool printOrders() const;

  private:
    std::ofstream csv_;
    std::vector<Row> rows_;
};

} // namespace tokay::benchmark
