#include "coupling/FluidMemory.hpp"

namespace tokay::coupling {
namespace {

/// Correcting for the whole of q would overshoot where q is a little smaller.
constexpr double correctedPart = 0.7;

} // namespace

Eigen::VectorXd FluidMemory::corrected(const Eigen::VectorXd& forces) {
    if (previous_.size() == 0) {
        previous_ = forces;
    }
    const Eigen::VectorXd previous = previous_;
    changeBefore_ = lastChange_;
    lastChange_ = (forces - previous).norm();
    previous_ = forces;
    if (isFirst_) {
        isFirst_ = false;
        return forces;
    }
    const double q = correctedPart * share_;
    return (forces - q * previous) / (1 - q);
}

bool FluidMemory::teaches() const {
    return lastChange_ >= contrast_ * share_ / (1 - share_) * changeBefore_;
}

} // namespace tokay::coupling
