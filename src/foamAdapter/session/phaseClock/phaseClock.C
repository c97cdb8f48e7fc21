// SPDX-License-Identifier: GPL-3.0-or-later
#include "phaseClock.H"

#include <ctime>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::phaseClock::now()
{
    return scalar(std::clock())/CLOCKS_PER_SEC;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::phaseClock::phaseClock()
:
    seconds_(Zero),
    present_(phase::other),
    start_(now())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::phaseClock::columns()
{
    return
    {
        "meshCpu[s]", "correctPhiCpu[s]", "UCpu[s]", "pCpu[s]",
        "couplingCpu[s]", "otherCpu[s]"
    };
}


void Foam::phaseClock::enter(const phase next)
{
    const scalar time = now();
    seconds_[label(present_)] += time - start_;
    present_ = next;
    start_ = time;
}


// ************************************************************************* //
