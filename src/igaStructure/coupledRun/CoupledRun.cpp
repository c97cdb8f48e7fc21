// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/CoupledRun.hpp"

#include "channel/PeerError.hpp"
#include "channel/encoding.hpp"
#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/case/readCoupling.hpp"
#include "igaStructure/coupledRun/CoupledStructure.hpp"
#include "igaStructure/coupledRun/FluidLink.hpp"
#include "igaStructure/coupledRun/PrescribedStructure.hpp"
#include "igaStructure/run/describeModel.hpp"
#include "igaStructure/run/requireSupports.hpp"

#include <fmt/format.h>

#include <optional>

namespace tokay::structure {

using channel::BeginStep;
using channel::Displacements;
using channel::Forces;
using channel::Goodbye;
using channel::Interface;
using channel::State;

namespace {

/// The session with the fluid: which message follows which.
class Session {
  public:
    Session(const Case& structureCase, FluidLink& link, const CoupledRunOptions& options,
            Report report)
        : case_(structureCase), link_(link), options_(options), report_(std::move(report)),
          body_(makeBody(structureCase)) {}

    void run() {
        report_(describeModel(case_, *body_));
        requireSupports(case_, body_->model());
        start();
        while (const std::optional<BeginStep> begin = nextStep()) {
            advance(*begin);
        }
    }

  private:
    void start();
    std::optional<BeginStep> nextStep();
    void advance(const BeginStep& begin);
    std::optional<Forces> nextForces();
    Answer answerTo(const Forces& forces);
    void send(State state, const Answer& answer);
    void record(const Answer& accepted);

    const Case& case_;
    FluidLink& link_;
    const CoupledRunOptions& options_;
    Report report_;
    std::unique_ptr<Body> body_;
    PhaseTimer timer_;
    std::optional<WetBoundary> boundary_;
    std::unique_ptr<StructureSide> structure_;
    std::optional<DisplacementRecorder> recorder_;
    bool fluidRetries_ = false;
    int step_ = 0;
    double time_ = 0;
};

std::string describeInterface(const Interface& fluid, const WetBoundary& boundary) {
    return fmt::format("interface {}: {} points, {} faces; from {:g} s to {:g} s, tolerance {:g}\n",
                       fluid.name, boundary.nPoints(), boundary.nFaces(), fluid.startTime,
                       fluid.endTime, fluid.tolerance);
}

void Session::start() {
    const Interface fluid = link_.receive<Interface>("the fluid's interface");
    fluidRetries_ = fluid.retries;
    boundary_.emplace(*body_, *case_.coupling, fluid);
    if (options_.replayFile.empty()) {
        structure_ =
            std::make_unique<CoupledStructure>(case_, *body_, *boundary_, fluid, timer_, report_);
    } else {
        structure_ = std::make_unique<PrescribedStructure>(
            DisplacementRecord(options_.replayFile, boundary_->nComponents()), report_);
    }
    if (!options_.recordFile.empty()) {
        recorder_.emplace(options_.recordFile, fluid.startTime);
    }
    std::string text = describeCoupling(*case_.coupling) + describeInterface(fluid, *boundary_) +
                       boundary_->report();
    if (case_.timeSteps) {
        text += "note: time steps and end come from the fluid; the case's time.step and time.end "
                "are not used\n";
    }
    report_(text);
    link_.send(channel::Accepted{describeModel(case_, *body_) + text});
}

// The next step, or none if the fluid says goodbye.
std::optional<BeginStep> Session::nextStep() {
    channel::Message message = timer_.time(Phase::waiting, [&] {
        return link_.receive(fmt::format("the fluid's next time step, after step {}", step_));
    });
    if (const auto* goodbye = std::get_if<Goodbye>(&message)) {
        report_("the fluid ends the run: " + goodbye->reason);
        link_.send(Goodbye{"all results are written"});
        return std::nullopt;
    }
    if (const auto* begin = std::get_if<BeginStep>(&message)) {
        return *begin;
    }
    throw channel::PeerError("the fluid sent another message where a time step had to begin");
}

void Session::advance(const BeginStep& begin) {
    step_ = static_cast<int>(begin.step);
    time_ = begin.time;
    if (!(begin.deltaT > 0)) {
        throw channel::PeerError(
            fmt::format("the fluid's time step {} has a length of {} s", step_, begin.deltaT));
    }
    const Eigen::VectorXd predicted = structure_->beginTimeStep(step_, begin.time, begin.deltaT);
    send(State::iterate, {predicted, 1, false});
    while (true) {
        const std::optional<Forces> forces = nextForces();
        if (!forces) {
            structure_->rejectTimeStep();
            return;
        }
        const Answer answer = answerTo(*forces);
        if (!answer.failure.empty()) {
            send(State::rejected, answer);
        } else if (forces->final) {
            record(answer);
            send(State::accepted, answer);
            return;
        } else {
            send(answer.converged ? State::converged : State::iterate, answer);
        }
    }
}

// The next forces, or none if the fluid rejects the step.
std::optional<Forces> Session::nextForces() {
    channel::Message message = timer_.time(Phase::waiting, [&] {
        return link_.receive(fmt::format("the fluid's forces, step {}", step_));
    });
    if (const auto* rejection = std::get_if<channel::RejectStep>(&message)) {
        report_(
            fmt::format("step {} time {:.6g} s is rejected: {}", step_, time_, rejection->reason));
        return std::nullopt;
    }
    if (auto* forces = std::get_if<Forces>(&message)) {
        return std::move(*forces);
    }
    throw channel::PeerError(
        fmt::format("the fluid sent a message of type {} where its forces had to "
                    "come",
                    channel::typeName(message.index())));
}

// A step without a solution is no end if the fluid tries it again.
Answer Session::answerTo(const Forces& forces) {
    try {
        return forces.final ? structure_->acceptTimeStep(forces.values, forces.write)
                            : structure_->iterate(forces.values, forces.fluidResidual);
    } catch (const SolverError& error) {
        if (!fluidRetries_) {
            throw;
        }
        Answer answer;
        answer.failure = error.what();
        return answer;
    }
}

void Session::send(State state, const Answer& answer) {
    const Eigen::VectorXd& values = answer.displacements;
    link_.send(Displacements{state,
                             answer.residual,
                             {values.data(), values.data() + values.size()},
                             answer.failure,
                             answer.balance});
}

void Session::record(const Answer& accepted) {
    if (recorder_) {
        recorder_->add(time_, accepted.displacements);
    }
}

void requireImplicit(const Case& structureCase) {
    if (structureCase.timeSteps &&
        (structureCase.timeSteps->largestPathSteps > 0 || structureCase.timeSteps->isExplicit)) {
        throw InputError(structureCase.file + ": time.scheme: arcLength and explicit are for a run "
                                              "alone; choose another scheme for a coupled one");
    }
}

} // namespace

void runCoupled(const std::string& caseFile, channel::Channel channel,
                const CoupledRunOptions& options, const Report& report) {
    FluidLink link(std::move(channel), options.silenceInterval, report);
    try {
        link.shakeHands(options.token);
        const Case structureCase = readCase(caseFile);
        if (!structureCase.coupling) {
            throw InputError(structureCase.file + ": entry 'coupling' is missing: a coupled run "
                                                  "needs it (coupling: {interface: [edges]})");
        }
        requireImplicit(structureCase);
        Session(structureCase, link, options, report).run();
    } catch (const channel::PeerFailure&) {
        throw; // it has ended already
    } catch (const std::exception& error) {
        link.tellFailure(error.what());
        throw;
    }
}

} // namespace tokay::structure
