// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/ColouredAssembly.hpp"

#include <omp.h>

#include <algorithm>
#include <exception>

namespace tokay::structure {

namespace {

// The first colour that no row with a node of this one has.
int freeColour(const std::vector<int>& nodes, const std::vector<std::vector<int>>& coloursOfNode) {
    std::vector<bool> taken;
    for (int node : nodes) {
        for (int colour : coloursOfNode[node]) {
            taken.resize(std::max<std::size_t>(taken.size(), colour + 1), false);
            taken[colour] = true;
        }
    }
    return static_cast<int>(std::find(taken.begin(), taken.end(), false) - taken.begin());
}

int largestNode(const std::vector<std::vector<int>>& nodesOfRows) {
    int largest = -1;
    for (const std::vector<int>& nodes : nodesOfRows) {
        for (int node : nodes) {
            largest = std::max(largest, node);
        }
    }
    return largest;
}

} // namespace

ColouredAssembly::ColouredAssembly(const std::vector<std::vector<int>>& nodesOfRows)
    : nRows_(static_cast<int>(nodesOfRows.size())) {
    std::vector<std::vector<int>> coloursOfNode(largestNode(nodesOfRows) + 1);
    for (int row = 0; row < nRows_; ++row) {
        const int colour = freeColour(nodesOfRows[row], coloursOfNode);
        for (int node : nodesOfRows[row]) {
            coloursOfNode[node].push_back(colour);
        }
        colours_.resize(std::max<std::size_t>(colours_.size(), colour + 1));
        colours_[colour].push_back(row);
    }
}

void ColouredAssembly::forEachRow(int nThreads, const Visit& visit) const {
    std::exception_ptr failure;
#pragma omp parallel num_threads(nThreads)
    {
        for (const std::vector<int>& rows : colours_) {
#pragma omp for schedule(dynamic, 1)
            for (std::size_t k = 0; k < rows.size(); ++k) {
                try {
                    visit(rows[k], omp_get_thread_num());
                } catch (...) {
#pragma omp critical
                    failure = std::current_exception();
                }
            }
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

int availableThreads() {
    return omp_get_max_threads();
}

} // namespace tokay::structure
