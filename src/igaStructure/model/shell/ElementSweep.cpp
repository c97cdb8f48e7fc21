#include "igaStructure/model/shell/ElementSweep.hpp"

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

int largestNode(const std::vector<std::unique_ptr<ShellPatch>>& patches) {
    int largest = -1;
    for (const auto& patch : patches) {
        largest =
            std::max(largest, *std::max_element(patch->nodes().begin(), patch->nodes().end()));
    }
    return largest;
}

} // namespace

ElementSweep::ElementSweep(const std::vector<std::unique_ptr<ShellPatch>>& patches) {
    std::vector<std::vector<int>> coloursOfNode(largestNode(patches) + 1);
    for (const auto& patch : patches) {
        for (int j = 0; j < patch->v().nSpans(); ++j) {
            const std::vector<int> nodes = patch->nodesOfRow(j);
            const int colour = freeColour(nodes, coloursOfNode);
            for (int node : nodes) {
                coloursOfNode[node].push_back(colour);
            }
            colours_.resize(std::max<std::size_t>(colours_.size(), colour + 1));
            colours_[colour].push_back(nRows());
            rows_.push_back({patch.get(), j});
        }
    }
}

void ElementSweep::forEachElement(int nThreads, const Visit& visit) const {
    std::exception_ptr failure;
#pragma omp parallel num_threads(nThreads)
    {
        ShellElement element;
        for (const std::vector<int>& rows : colours_) {
#pragma omp for schedule(dynamic, 1)
            for (std::size_t k = 0; k < rows.size(); ++k) {
                const Row& row = rows_[rows[k]];
                try {
                    for (int i = 0; i < row.patch->u().nSpans(); ++i) {
                        element.moveTo(*row.patch, i, row.number);
                        if (element.nPoints() > 0) {
                            visit(element, omp_get_thread_num(), rows[k]);
                        }
                    }
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
