// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::structure {

/// An end of a line: where its parameter starts, or ends.
enum class LineEnd { start, end };

/// What is held at an end of a line.
struct LineSupport {
    LineEnd end;
    bool x = false;
    bool y = false;
    bool rotation = false;
    bool z = false; ///< in space
};

} // namespace tokay::structure
