// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// What a part of a coupling method carries from time step to time step.
///
/// Life cycle: beginTimeStep(), then the coupling iterations of the step, then
/// either acceptTimeStep(), by which the step becomes history, or
/// rejectTimeStep(), after which all is as it was before beginTimeStep(): the
/// step will be tried again, shorter. Between two time steps save() writes the
/// history, and restore() continues from it bit by bit.
class StepHistory {
  public:
    virtual ~StepHistory() = default;

    virtual void beginTimeStep() {}
    virtual void acceptTimeStep() {}
    virtual void rejectTimeStep() {}

    virtual void save(StateWriter&) const {}
    /// @throws channel::PeerError if the state is damaged
    virtual void restore(StateReader&) {}
};

} // namespace tokay::coupling
