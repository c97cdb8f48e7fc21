// SPDX-License-Identifier: GPL-3.0-or-later
#include "stepRetry.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::stepRetry::isAdjusted() const
{
    return time_.controlDict().lookupOrDefault("adjustTimeStep", false);
}


Foam::scalar Foam::stepRetry::shorterDeltaT() const
{
    // By so much the solver makes it longer again before it is taken
    constexpr scalar growth = 1.2;

    return isAdjusted()
      ? 0.5*time_.deltaTValue()/growth
      : deltaT_/(label(1) << (level_ + 1));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepRetry::stepRetry(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    time_(const_cast<Time&>(mesh.time())),
    deltaT_(time_.deltaTValue()),
    minDeltaT_
    (
        dict.subOrEmptyDict("retry").getCheckOrDefault<scalar>
        (
            "minDeltaT",
            1e-3*deltaT_,
            scalarMinMax::ge(SMALL*deltaT_)
        )
    ),
    before_(new quietTime(time_)),
    isRepeated_(false),
    level_(0),
    nDone_(0),
    nGood_(0)
{
    requireKnownEntries(dict.subOrEmptyDict("retry"), {"minDeltaT"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepRetry::beginTimeStep()
{
    if (isRepeated_)
    {
        snapshot_->restoreFields();
        time_.functionObjects().on();
        return;
    }
    if (level_ == 0)
    {
        deltaT_ = time_.deltaTValue();
    }
    snapshot_.reset(new fluidSnapshot(mesh_));
}


void Foam::stepRetry::endureTimeStep()
{
    if (!isEnduring_)
    {
        std::feholdexcept(&exceptions_);
        isEnduring_ = true;
    }
}


void Foam::stepRetry::endTimeStep()
{
    isRepeated_ = false;
    before_.reset(new quietTime(time_));
    if (level_ == 0 || isAdjusted())
    {
        return;
    }
    ++nDone_;
    ++nGood_;
    if (nGood_ >= 2 && nDone_ % 2 == 0)
    {
        --level_;
        nDone_ /= 2;
        nGood_ = 0;
    }
    if (nDone_ == label(1) << level_)
    {
        nDone_ = 0;
    }
    time_.setDeltaT(deltaT_/(label(1) << level_), false);
}


bool Foam::stepRetry::isPossible() const
{
    return shorterDeltaT() >= minDeltaT_*(1 - SMALL);
}


Foam::scalar Foam::stepRetry::rejectTimeStep()
{
    const scalar deltaT = shorterDeltaT();
    if (!isAdjusted())
    {
        ++level_;
        nDone_ *= 2;
        nGood_ = 0;
    }
    isRepeated_ = true;

    if (before_().timeIndex() == 0)
    {
        before_().pretendStep(deltaT);
    }

    snapshot_->restore();
    if (isEnduring_)
    {
        std::fesetenv(&exceptions_);
        isEnduring_ = false;
    }
    // So that the solver does not make relative what is so already
    const_cast<fvMesh&>(mesh_).moving(false);

    static_cast<TimeState&>(time_) = before_();
    time_.setTime(before_().value(), before_().timeIndex());
    time_.setDeltaT(deltaT, false);
    time_.functionObjects().off();
    return deltaT;
}


// ************************************************************************* //
