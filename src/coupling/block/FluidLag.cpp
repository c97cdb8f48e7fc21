// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/FluidLag.hpp"

#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

namespace tokay::coupling {
namespace {

/// Correcting for the whole of q would overshoot where q is a little smaller.
constexpr double correctedPart = 0.7;

} // namespace

void FluidLag::beginTimeStep() {
    isFirst_ = true;
    atBegin_ = last_;
}

Eigen::VectorXd FluidLag::corrected(const Eigen::VectorXd& loads) {
    if (options_.fluidMemory == 0) {
        return loads;
    }
    const Last before = last_;
    changeBefore_ = before.change;
    last_ = {loads, before.loads.size() == 0 ? 0 : (loads - before.loads).norm()};
    if (isFirst_) {
        isFirst_ = false;
        return loads;
    }
    const double q = correctedPart * options_.fluidMemory;
    return (loads - q * before.loads) / (1 - q);
}

// Compares with the lag that the correction has left.
bool FluidLag::isInformative() const {
    const double q = options_.fluidMemory;
    const double left = (1 - correctedPart) * q / (1 - correctedPart * q);
    return last_.change >= options_.memoryContrast * left / (1 - left) * changeBefore_;
}

void FluidLag::save(StateWriter& state) const {
    state.matrix(last_.loads);
    state.number(last_.change);
}

void FluidLag::restore(StateReader& state) {
    last_.loads = state.vector();
    last_.change = state.number();
}

} // namespace tokay::coupling
