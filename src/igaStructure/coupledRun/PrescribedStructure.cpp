// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/PrescribedStructure.hpp"

#include <fmt/format.h>

namespace tokay::structure {

Eigen::VectorXd PrescribedStructure::beginTimeStep(int step, double time, double) {
    step_ = step;
    time_ = time;
    nExchanges_ = 0;
    displacements_ = record_.at(time);
    return displacements_;
}

StructureResponse PrescribedStructure::iterate(const Eigen::VectorXd&, std::optional<double>) {
    ++nExchanges_;
    return {displacements_, 0, true};
}

StructureResponse PrescribedStructure::acceptTimeStep(const channel::Forces&) {
    ++nExchanges_;
    return {displacements_, 0, true, true};
}

void PrescribedStructure::finishTimeStep() {
    report_(fmt::format("step {} time {:.6g} s  exchanges {}  prescribed motion", step_, time_,
                        nExchanges_));
}

} // namespace tokay::structure
