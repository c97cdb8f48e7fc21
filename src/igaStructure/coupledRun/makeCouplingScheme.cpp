// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/BlockScheme.hpp"
#include "igaStructure/coupledRun/FixedPointScheme.hpp"

namespace tokay::structure {

std::unique_ptr<CouplingScheme> makeCouplingScheme(const coupling::CouplingOptions& options,
                                                   double tolerance, WetStructure& structure,
                                                   const Eigen::VectorXd& initial,
                                                   PhaseTimer& timer) {
    if (options.acceleration == coupling::Acceleration::block) {
        return std::make_unique<BlockScheme>(options, tolerance, structure, initial, timer);
    }
    return std::make_unique<FixedPointScheme>(options, tolerance, structure, initial, timer);
}

} // namespace tokay::structure
