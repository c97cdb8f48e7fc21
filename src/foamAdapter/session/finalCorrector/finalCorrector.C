// SPDX-License-Identifier: GPL-3.0-or-later
#include "finalCorrector.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::finalCorrector::ranOut(const label corrector) const
{
    if (residual_.isExplicit())
    {
        return false;
    }
    return
        !step_.current().converged
     || (
            corrector == pimple_.nCorrPIMPLE()
         && !criteria_.fluidConverged()
        );
}


void Foam::finalCorrector::failUnconverged(const label corrector)
{
    const stepController::statistics& current = step_.current();
    OStringStream os;
    os  << "time " << time_.timeName() << " s did not converge in "
        << corrector << " outer correctors: "
        << criteria_.describe
           (
               current.residual,
               residual_.tolerance(),
               current.converged
           ).c_str();
    step_.failUnconverged(os.str(), criteria_.remedy(current.converged));
}


void Foam::finalCorrector::reportUnlimited()
{
    // A hundred times the usual tolerance
    constexpr scalar limit = 0.01;

    const scalar residual = step_.current().fluidResidual;
    if (watchesMomentum_ && residual > limit)
    {
        watchesMomentum_ = false;
        WarningInFunction
            << "the time step ending at " << time_.timeName()
            << " s is accepted with a momentum residual of " << residual
            << ", which residualControl does not limit" << endl;
    }
}


void Foam::finalCorrector::endWithoutAcceptance
(
    const label corrector,
    const std::function<void(bool)>& exchange
)
{
    step_.current().converged = false;
    if (corrector < pimple_.nCorrPIMPLE())
    {
        residual_.reopenLoop(step_.current().residual);
        return;
    }
    failUnconverged(corrector);
    if (!step_.hasFailed())
    {
        exchange(false);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::finalCorrector::finalCorrector
(
    const Time& time,
    const pimpleControl& pimple,
    couplingResidual& residual,
    const residualCriteria& criteria,
    stepController& step
)
:
    time_(time),
    pimple_(pimple),
    residual_(residual),
    criteria_(criteria),
    step_(step),
    watchesMomentum_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::finalCorrector::end
(
    const label corrector,
    const std::function<void(bool)>& exchange
)
{
    bool ifConverged = !residual_.isExplicit();
    if (!step_.hasFailed() && ranOut(corrector))
    {
        failUnconverged(corrector);
        ifConverged = false;
    }
    if (!step_.hasFailed())
    {
        exchange(ifConverged);
    }
    if (!step_.hasFailed() && !step_.isAccepted())
    {
        endWithoutAcceptance(corrector, exchange);
    }
    if (step_.hasFailed())
    {
        step_.reject();
    }
    else if (step_.isAccepted())
    {
        reportUnlimited();
    }
}


// ************************************************************************* //
