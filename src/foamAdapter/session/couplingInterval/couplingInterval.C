// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingInterval.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::couplingInterval::readInterval(const dictionary& dict)
{
    if (!dict.found("couplingInterval"))
    {
        return 1;
    }
    const token value(dict.lookup("couplingInterval"));
    if (value.isWord() && value.wordToken() == "fluidConverged")
    {
        return 0;
    }
    if (!value.isLabel() || value.labelToken() < 1)
    {
        FatalIOErrorInFunction(dict)
            << "couplingInterval: " << value << "; allowed: a number of outer "
            << "correctors, at least 1, or fluidConverged"
            << exit(FatalIOError);
    }
    return value.labelToken();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingInterval::couplingInterval
(
    const dictionary& dict,
    const couplingResidual& residual,
    const residualCriteria& criteria
)
:
    nCorrectors_(readInterval(dict)),
    criteria_(criteria)
{
    if
    (
        nCorrectors_ == 0
     && !residual.isExplicit()
     && !criteria.controlsMomentum()
    )
    {
        FatalIOErrorInFunction(dict)
            << "couplingInterval: fluidConverged; residualControl has no "
            << "entry for the velocity, which decides when that is" << nl
            << "    add 'U { tolerance 1e-4; relTol 0; }' to residualControl "
            << "in fvSolution" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::couplingInterval::isDue(const label nCorrectors) const
{
    return nCorrectors_ == 0
      ? criteria_.momentumConverged()
      : nCorrectors >= nCorrectors_;
}


// ************************************************************************* //
