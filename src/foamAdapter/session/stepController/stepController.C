// SPDX-License-Identifier: GPL-3.0-or-later
#include "stepController.H"
#include "dictionaryChecks.H"
#include "Time.H"

#include <chrono>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::stepController::unconverged>
Foam::stepController::unconvergedNames
({
    {unconverged::abort, "abort"},
    {unconverged::warn, "warn"},
    {unconverged::retry, "retry"}
});

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepController::stepController
(
    const dictionary& dict,
    const fvMesh& mesh,
    structureConnection& structure
)
:
    time_(mesh.time()),
    structure_(structure),
    onUnconverged_
    (
        readChoice
        (
            "onUnconverged", dict, unconvergedNames, unconverged::abort
        )
    ),
    retry_
    (
        onUnconverged_ == unconverged::retry
      ? new stepRetry(dict, mesh)
      : nullptr
    ),
    timeIndex_(-1),
    accepted_(false),
    start_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::stepController::wallClock()
{
    return std::chrono::duration<scalar>
    (
        std::chrono::steady_clock::now().time_since_epoch()
    ).count();
}


bool Foam::stepController::hasBegun() const
{
    return timeIndex_ == time_.timeIndex();
}


Foam::label Foam::stepController::number() const
{
    return time_.timeIndex() - time_.startTimeIndex();
}


void Foam::stepController::begin()
{
    start_ = wallClock();
    current_ = statistics();
    current_.deltaT = time_.deltaTValue();
    accepted_ = false;
    failure_.clear();
    if (retry_.valid())
    {
        retry_->beginTimeStep();
    }
    timeIndex_ = time_.timeIndex();
}


void Foam::stepController::fail(const string& reason, const string& remedy)
{
    if (!retry_.valid())
    {
        structure_.fail(reason + remedy);
    }
    failure_ = reason;
}


void Foam::stepController::failMesh(const string& cells)
{
    fail
    (
        cells,
        ". Reduce deltaT, repeat such steps with a shorter one by "
        "'onUnconverged retry', or choose another mesh motion or diffusivity"
    );
    retry_->endureTimeStep();
}


void Foam::stepController::failUnconverged
(
    const string& reason,
    const string& remedy
)
{
    if (onUnconverged_ == unconverged::warn)
    {
        WarningInFunction << reason.c_str() << nl
            << "    accepted nevertheless, by 'onUnconverged warn'"
            << endl;
        return;
    }
    fail
    (
        reason,
        remedy
      + ". Raise nOuterCorrectors, reduce deltaT, repeat such steps by "
        "'onUnconverged retry', or accept them by 'onUnconverged warn'"
    );
}


void Foam::stepController::reject()
{
    if (!retry_->isPossible())
    {
        OStringStream os;
        os  << ". Half of deltaT " << time_.deltaTValue()
            << " s would be below 'minDeltaT' " << retry_->minDeltaT()
            << " s of 'retry': lower it, or look for the cause";
        structure_.fail(failure_ + os.str());
    }
    const word time(time_.timeName());
    structure_.reject(failure_);
    const scalar deltaT = retry_->rejectTimeStep();
    timeIndex_ = -1;
    Info<< "structureCoupling: time step ending at t = " << time
        << " s rejected: " << failure_.c_str() << nl
        << "    retrying with deltaT = " << deltaT << " s" << nl << endl;
}


const Foam::stepController::statistics& Foam::stepController::end()
{
    if (!accepted_)
    {
        structure_.fail
        (
            "the time step has ended without its final outer corrector, so "
            "the structure has not accepted it: is 'solveFlow' on?"
        );
    }
    accepted_ = false;
    current_.stepSeconds = wallClock() - start_;
    current_.phases.enter(phaseClock::phase::other);
    if (retry_.valid())
    {
        retry_->endTimeStep();
    }
    return current_;
}


// ************************************************************************* //
