// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchangeHook.H"
#include "couplingSession.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(exchangeHook, 0);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What an fvOption wants to find in its dictionary
Foam::dictionary hookDict()
{
    Foam::dictionary dict;
    dict.add("active", true);
    dict.add
    (
        Foam::word(Foam::fv::exchangeHook::typeName + "Coeffs"),
        Foam::dictionary()
    );
    return dict;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::exchangeHook::exchangeHook
(
    const couplingSession& session,
    const fvMesh& mesh
)
:
    option(session.name(), typeName, hookDict(), mesh),
    sessionName_(session.name())
{
    fieldNames_.setSize(1, session.UName());
    applied_.setSize(1, false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::exchangeHook::correct(volVectorField&)
{
    couplingSession& session =
        mesh_.lookupObjectRef<couplingSession>(sessionName_);
    session.endVelocitySolution();

    const pimpleControl& pimple =
        mesh_.lookupObject<pimpleControl>("solutionControl");

    if (pimple.corrPISO() == pimple.nCorrPISO())
    {
        session.endCorrector();
    }
}


// ************************************************************************* //
