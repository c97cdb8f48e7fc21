// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/MappingReport.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

std::string MappingReport::text() const {
    std::string text =
        fmt::format("mapping: {}\n"
                    "  points {} (unmatched {}, ambiguous {}), coverage {:.1f} %\n"
                    "  largest gap {:.3g} m ({:.3g} of the interface size) at point {}\n"
                    "  errors: constant {:.1e}, force sum {:.1e}, moment {:.1e}\n",
                    method, nPoints, nUnmatched, nAmbiguous, 100 * coverage, largestGap,
                    relativeGap, worstPoint, rowSumError, forceSumError, momentError);
    if (nUncovered > 0) {
        text += fmt::format("  destination values that get nothing: {}\n", nUncovered);
    }
    if (nInverted > 0) {
        text +=
            fmt::format("  mass matrix {0} x {0}, rank {1}{2}, condition on the range {3:.3g}\n",
                        nInverted, rank, rank < nInverted ? " (singular)" : "", condition);
    }
    if (!regularisation.empty()) {
        text += fmt::format("  the trace of {} functions has only {} dimensions: the other "
                            "values are chosen by the {}\n",
                            nInverted, rank, regularisation);
    }
    return text + fmt::format("  built in {:.3g} s, {:.3g} MB\n", seconds, bytes / 1e6);
}

JsonObject MappingReport::json() const {
    JsonObject object;
    object.add("method", method);
    object.add("nPoints", nPoints);
    object.add("nUnmatched", nUnmatched);
    object.add("nAmbiguous", nAmbiguous);
    object.add("coverage", coverage);
    object.add("largestGap_m", largestGap);
    object.add("relativeGap", relativeGap);
    object.add("worstPoint", worstPoint);
    object.add("rowSumError", rowSumError);
    object.add("forceSumError", forceSumError);
    object.add("momentError", momentError);
    object.add("nUncovered", nUncovered);
    object.add("nInverted", nInverted);
    object.add("rank", rank);
    object.add("condition", condition);
    object.add("regularisation", regularisation);
    object.add("build_s", seconds);
    object.add("memory_byte", bytes);
    return object;
}

} // namespace tokay::mapper
