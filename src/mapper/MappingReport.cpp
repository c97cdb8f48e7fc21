#include "mapper/MappingReport.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

std::string MappingReport::text() const {
    return fmt::format("mapping: {}\n"
                       "  points {} (unmatched {}, ambiguous {}), coverage {:.1f} %\n"
                       "  largest gap {:.3g} m ({:.3g} of the interface size) at point {}\n"
                       "  errors: constant {:.1e}, force sum {:.1e}, moment {:.1e}\n"
                       "  built in {:.3g} s, {:.3g} MB\n",
                       method, nPoints, nUnmatched, nAmbiguous, 100 * coverage, largestGap,
                       relativeGap, worstPoint, rowSumError, forceSumError, momentError, seconds,
                       bytes / 1e6);
}

} // namespace tokay::mapper
