// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchangePolicy.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::exchangePolicy::moment>
Foam::exchangePolicy::momentNames
({
    {moment::everyCorrector, "everyCorrector"},
    {moment::interval, "interval"},
    {moment::fluidConverged, "fluidConverged"}
});

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::exchangePolicy::readInterval
(
    const dictionary& dict,
    const moment when
)
{
    if (when != moment::interval)
    {
        if (dict.found("exchangeInterval"))
        {
            FatalIOErrorInFunction(dict)
                << "'exchangeInterval' is given, but 'exchange' is '"
                << momentNames[when] << "'" << nl
                << "    set 'exchange interval;' or remove it"
                << exit(FatalIOError);
        }
        return 1;
    }
    const label interval = dict.get<label>("exchangeInterval");
    if (interval < 1)
    {
        FatalIOErrorInFunction(dict)
            << "'exchangeInterval' is " << interval
            << ": it must be at least 1" << exit(FatalIOError);
    }
    return interval;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exchangePolicy::exchangePolicy
(
    const dictionary& dict,
    const couplingResidual& residual
)
:
    moment_
    (
        momentNames.getOrDefault("exchange", dict, moment::everyCorrector)
    ),
    interval_(readInterval(dict, moment_)),
    residual_(residual)
{
    if
    (
        moment_ == moment::fluidConverged
     && !residual.isExplicit()
     && !residual.controlsMomentum()
    )
    {
        FatalIOErrorInFunction(dict)
            << "'exchange' is 'fluidConverged', but residualControl has no "
            << "entry for the velocity, which says when that is" << nl
            << "    add 'U { tolerance 1e-4; relTol 0; }' to residualControl "
            << "in fvSolution" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::exchangePolicy::isDue(const label nCorrectors) const
{
    return moment_ == moment::fluidConverged
      ? residual_.momentumConverged()
      : nCorrectors >= interval_;
}


// ************************************************************************* //
