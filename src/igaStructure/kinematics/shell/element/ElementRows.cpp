// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/ElementRows.hpp"

namespace tokay::structure {

namespace {

std::vector<std::vector<int>> nodesOfRows(const std::vector<std::unique_ptr<ShellPatch>>& patches) {
    std::vector<std::vector<int>> nodes;
    for (const auto& patch : patches) {
        for (int j = 0; j < patch->v().nSpans(); ++j) {
            nodes.push_back(patch->nodesOfRow(j));
        }
    }
    return nodes;
}

} // namespace

ElementRows::ElementRows(const std::vector<std::unique_ptr<ShellPatch>>& patches)
    : colours_(nodesOfRows(patches)) {
    for (const auto& patch : patches) {
        for (int j = 0; j < patch->v().nSpans(); ++j) {
            rows_.push_back({patch.get(), j});
        }
    }
}

void ElementRows::forEachElement(int nThreads, const Visit& visit) const {
    std::vector<ShellElement> elements(nThreads);
    colours_.forEachRow(nThreads, [&](int number, int thread) {
        const Row& row = rows_[number];
        ShellElement& element = elements[thread];
        for (int i = 0; i < row.patch->u().nSpans(); ++i) {
            element.moveTo(*row.patch, i, row.number);
            if (element.nPoints() > 0) {
                visit(element, thread, number);
            }
        }
    });
}

} // namespace tokay::structure
