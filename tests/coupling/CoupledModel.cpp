// SPDX-License-Identifier: GPL-3.0-or-later
#include "CoupledModel.hpp"

#include "coupling/block/BlockSystem.hpp"

namespace tokay::coupling {

Eigen::VectorXd CoupledModel::structure(const Eigen::VectorXd& forces,
                                        const Eigen::VectorXd& start) {
    WoodburySolver steps(*this);
    return BlockSystem(*this, steps, forces, start, LowRankMatrix()).solve(start, 1e-12);
}

} // namespace tokay::coupling
