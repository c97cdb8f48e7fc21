// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/CoupledSession.hpp"

#include "channel/PeerError.hpp"
#include "channel/allFinite.hpp"
#include "channel/encoding.hpp"
#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/coupledRun/FsiParticipant.hpp"
#include "igaStructure/coupledRun/PrescribedStructure.hpp"
#include "igaStructure/coupledRun/wetCoverage.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/run/describeModel.hpp"
#include "igaStructure/run/requireSupports.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace tokay::structure {

using channel::BeginStep;
using channel::Forces;
using channel::Goodbye;
using channel::PeerError;
using channel::State;
using Eigen::VectorXd;

namespace {

std::string describeInterface(const channel::Interface& fluid, const WetBoundary& boundary) {
    return fmt::format("interface {}: {} points, {} faces; from {:g} s to {:g} s, tolerance {:g}\n",
                       fluid.name, boundary.nPoints(), boundary.nFaces(), fluid.startTime,
                       fluid.endTime, fluid.tolerance);
}

std::string text(const VectorXd& components) {
    return fmt::format("({:.6g})", fmt::join(components, ", "));
}

Eigen::Map<const VectorXd> asVector(const std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// The place where forces are checked: inside they are finite, and one per face.
void requireUsable(const Forces& forces, const WetBoundary& boundary) {
    const int dimension = boundary.dimension();
    if (forces.values.size() != static_cast<std::size_t>(dimension) * boundary.nFaces()) {
        throw PeerError(fmt::format("the fluid sent {} force components for {} faces",
                                    forces.values.size(), boundary.nFaces()));
    }
    for (int face = 0; face < boundary.nFaces(); ++face) {
        const VectorXd force = asVector(forces.values).segment(dimension * face, dimension);
        if (!force.allFinite()) {
            throw PeerError(fmt::format(
                "the fluid's force on face {} at {} is not finite: {}; the flow has diverged", face,
                text(boundary.faceCentre(face)), text(force)));
        }
    }
    const double residual = forces.fluidResidual.value_or(0);
    if (!(residual >= 0 && std::isfinite(residual))) {
        throw PeerError(fmt::format("the fluid's residual is {}; the flow has diverged", residual));
    }
    if (!channel::allFinite(forces.fluidTimes)) {
        throw PeerError("the fluid has a time that is not finite");
    }
}

// Names of time folders have few digits: a start may be this part of a step off.
constexpr double beginTolerance = 0.1;

/// A step begins where the last accepted one has ended.
void requireUsable(const BeginStep& begin, double acceptedTime) {
    const bool isStep = begin.deltaT > 0 && std::isfinite(begin.deltaT) &&
                        std::isfinite(begin.time) &&
                        begin.step <= static_cast<std::uint32_t>(std::numeric_limits<int>::max());
    if (!isStep) {
        throw PeerError(
            fmt::format("the fluid's time step {} ends at {} s and has a length of {} s",
                        begin.step, begin.time, begin.deltaT));
    }
    const double start = begin.time - begin.deltaT;
    if (!(std::abs(start - acceptedTime) <= beginTolerance * begin.deltaT)) {
        throw PeerError(fmt::format(
            "the fluid's time step {} begins at {:.9g} s, but the structure is at {:.9g} s",
            begin.step, start, acceptedTime));
    }
}

} // namespace

CoupledSession::CoupledSession(const Case& structureCase, FluidLink& link,
                               const CoupledRunOptions& options, Report report)
    : case_(structureCase), link_(link), options_(options), report_(std::move(report)),
      body_(makeBody(structureCase)) {}

void CoupledSession::run() {
    report_(describeModel(case_, *body_));
    requireSupports(case_, body_->model());
    start();
    while (const std::optional<BeginStep> begin = nextStep()) {
        advance(*begin);
    }
}

void CoupledSession::start() {
    const auto fluid = link_.receive<channel::Interface>("the fluid's interface");
    fluidRetries_ = fluid.retries;
    acceptedTime_ = fluid.startTime;
    boundary_.emplace(*body_, *case_.coupling, fluid);
    const std::string unreached = boundary_->isEdge() ? "" : checkCoverage();
    if (options_.replayFile.empty()) {
        participant_ =
            std::make_unique<FsiParticipant>(case_, *body_, *boundary_, fluid, timer_, report_);
    } else {
        participant_ = std::make_unique<PrescribedStructure>(
            DisplacementRecord(options_.replayFile, boundary_->nComponents()), report_);
    }
    if (!options_.recordFile.empty()) {
        recorder_.emplace(options_.recordFile, fluid.startTime);
    }
    std::string text = (boundary_->isEdge() ? describeEdgeCoupling(*case_.coupling)
                                            : describeCoupling(*case_.coupling)) +
                       describeInterface(fluid, *boundary_) + boundary_->report() + unreached;
    if (case_.timeSteps) {
        text += fmt::format("note: time steps and end come from {}; the case's time.step and "
                            "time.end are not used\n",
                            link_.peer());
    }
    report_(text);
    link_.send(channel::Accepted{describeModel(case_, *body_) + text,
                                 case_.coupling->options.convergence.limitsForce()});
}

/// @return  parts that the fluid does not reach, in words
std::string CoupledSession::checkCoverage() const {
    const WetSurface wet = body_->wetSurface(case_.coupling->interface);
    const mapper::FaceMesh& fluid = boundary_->faces().mesh();
    requireFacesOnBody(wet, fluid);
    const std::vector<WetPart> parts = wetCoverage(wet, fluid);
    if (!case_.coupling->interface.empty() && case_.coupling->unreached == UnreachedParts::refuse) {
        requireReached(parts);
    }
    return describeUnreached(parts);
}

// The next step, or none if the fluid says goodbye.
std::optional<BeginStep> CoupledSession::nextStep() {
    const channel::Message message =
        receive(fmt::format("the fluid's next time step, after step {}", step_));
    if (const auto* goodbye = std::get_if<Goodbye>(&message)) {
        report_(link_.peer() + " ends the run: " + goodbye->reason);
        link_.send(Goodbye{"all results are written"});
        return std::nullopt;
    }
    if (const auto* begin = std::get_if<BeginStep>(&message)) {
        return *begin;
    }
    throw PeerError(fmt::format("protocol error: expected BeginStep, received {}",
                                channel::typeName(message.index())));
}

void CoupledSession::advance(const BeginStep& begin) {
    requireUsable(begin, acceptedTime_);
    step_ = static_cast<int>(begin.step);
    time_ = begin.time;
    send(State::iterate, {participant_->beginTimeStep(step_, begin.time, begin.deltaT)});
    while (const std::optional<Forces> forces = nextForces()) {
        const StructureResponse response = respondTo(*forces);
        if (!response.failure.empty()) {
            send(State::rejected, response);
        } else if (!response.accepted) {
            send(response.converged ? State::converged : State::iterate, response);
        } else {
            acceptedTime_ = time_;
            // The fluid may start again from a time that it writes, and the tables would have
            // a gap: their rows are there first. Else they overlap with the fluid's next step.
            if (forces->write) {
                finishTimeStep(response);
                send(State::accepted, response);
            } else {
                send(State::accepted, response);
                finishTimeStep(response);
            }
            if (!forces->fluidTimes.empty()) {
                participant_->removeStatesExcept(forces->fluidTimes);
            }
            return;
        }
    }
    participant_->rejectTimeStep();
}

void CoupledSession::finishTimeStep(const StructureResponse& response) {
    if (recorder_) {
        recorder_->add(time_, response.displacements);
    }
    participant_->finishTimeStep();
}

// The next forces, or none if the fluid rejects the step.
std::optional<Forces> CoupledSession::nextForces() {
    channel::Message message = receive(fmt::format("the fluid's forces, step {}", step_));
    if (const auto* rejection = std::get_if<channel::RejectStep>(&message)) {
        report_(
            fmt::format("step {} time {:.6g} s is rejected: {}", step_, time_, rejection->reason));
        return std::nullopt;
    }
    if (auto* forces = std::get_if<Forces>(&message)) {
        requireUsable(*forces, *boundary_);
        return std::move(*forces);
    }
    throw PeerError(fmt::format("protocol error: expected Forces, received {}",
                                channel::typeName(message.index())));
}

// A step without a solution is no end if the fluid tries it again.
StructureResponse CoupledSession::respondTo(const Forces& forces) {
    try {
        const VectorXd faceForces = asVector(forces.values);
        return forces.final ? participant_->acceptTimeStep(forces)
                            : participant_->iterate(faceForces, forces.fluidResidual);
    } catch (const SolverError& error) {
        if (!fluidRetries_) {
            throw;
        }
        StructureResponse response;
        response.failure = error.what();
        return response;
    }
}

channel::Message CoupledSession::receive(const std::string& waitingFor) {
    const auto timed = timer_.enter(Phase::waiting);
    return link_.receive(waitingFor);
}

void CoupledSession::send(State state, const StructureResponse& response) {
    const VectorXd& values = response.displacements;
    link_.send(channel::Displacements{state,
                                      response.residual,
                                      {values.data(), values.data() + values.size()},
                                      response.failure,
                                      response.balance});
}

} // namespace tokay::structure
