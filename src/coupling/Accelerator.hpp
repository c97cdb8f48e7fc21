// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <memory>

namespace tokay::coupling {

struct CouplingOptions;
class StateReader;
class StateWriter;

/// Finds the displacement for the next exchange in the search for x = xTilde,
/// where xTilde is the structure's answer to the fluid's forces at x.
class Accelerator {
  public:
    virtual ~Accelerator() = default;

    virtual void beginTimeStep() {}

    /// @param x              displacement that the forces belong to
    /// @param xTilde         displacement that these forces cause
    /// @param fluidResidual  how far the fluid is from its own answer, relative
    /// @return               x of the next exchange
    virtual Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                                 double fluidResidual) = 0;

    virtual void acceptTimeStep() {}

    /// Forgets what this step has taught.
    virtual void rejectTimeStep() {}

    /// What earlier steps have taught, between two time steps.
    virtual void save(StateWriter&) const {}
    /// Goes on from what save() wrote. @throws channel::PeerError if it is another method's
    virtual void restore(StateReader&) {}

    /// Pairs of differences in use, for statistics.
    virtual int nColumns() const { return 0; }
};

/// The accelerator that the options name; none for explicit coupling.
std::unique_ptr<Accelerator> makeAccelerator(const CouplingOptions& options);

} // namespace tokay::coupling
