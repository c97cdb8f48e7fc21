// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ColouredAssembly.hpp"
#include "igaStructure/kinematics/shell/element/ShellElement.hpp"
#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace tokay::structure {

/// Goes through all elements of a shell on several threads. Rows of elements that
/// share nodes never run at the same time, and always in the same order, so what
/// they add to nodes is the same to the last bit for any number of threads.
class ElementRows {
  public:
    /// The patches are borrowed.
    explicit ElementRows(const std::vector<std::unique_ptr<ShellPatch>>& patches);

    /// Rows of elements, of all patches.
    int nRows() const { return static_cast<int>(rows_.size()); }

    /// @param visit  is called for each element that has points, with the number of
    ///               its thread and of its row
    using Visit = std::function<void(ShellElement&, int thread, int row)>;
    void forEachElement(int nThreads, const Visit& visit) const;

  private:
    struct Row {
        const ShellPatch* patch;
        int number;
    };
    std::vector<Row> rows_;
    ColouredAssembly colours_;
};

} // namespace tokay::structure
