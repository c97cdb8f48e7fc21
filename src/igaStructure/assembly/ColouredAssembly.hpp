// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace tokay::structure {

/// Goes through rows of elements on several threads. Rows that share nodes never
/// run at the same time, and always in the same order, so what they add to nodes is
/// the same to the last bit for any number of threads.
class ColouredAssembly {
  public:
    /// @param nodesOfRows  without negative numbers
    explicit ColouredAssembly(const std::vector<std::vector<int>>& nodesOfRows);

    int nRows() const { return nRows_; }

    /// @param visit  is called for each row, with the number of its thread
    using Visit = std::function<void(int row, int thread)>;
    void forEachRow(int nThreads, const Visit& visit) const;

  private:
    int nRows_;
    std::vector<std::vector<int>> colours_; ///< rows of each
};

/// Number of threads for assembly: of processors, or OMP_NUM_THREADS.
int availableThreads();

} // namespace tokay::structure
