// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingFvOption.H"
#include "couplingSession.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(couplingFvOption, 0);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Entries that an fvOption expects in its dictionary
Foam::dictionary optionDict()
{
    Foam::dictionary dict;
    dict.add("active", true);
    dict.add
    (
        Foam::word(Foam::fv::couplingFvOption::typeName + "Coeffs"),
        Foam::dictionary()
    );
    return dict;
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::couplingSession& Foam::fv::couplingFvOption::session() const
{
    return mesh_.lookupObjectRef<couplingSession>(sessionName_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::couplingFvOption::couplingFvOption
(
    const couplingSession& session,
    const fvMesh& mesh
)
:
    option(session.name(), typeName, optionDict(), mesh),
    sessionName_(session.name())
{
    fieldNames_.setSize(1, session.UName());
    applied_.setSize(1, false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::couplingFvOption::addSup(fvMatrix<vector>&, const label)
{
    session().beginMomentum();
}


void Foam::fv::couplingFvOption::addSup
(
    const volScalarField&,
    fvMatrix<vector>&,
    const label
)
{
    session().beginMomentum();
}


void Foam::fv::couplingFvOption::correct(volVectorField&)
{
    session().endVelocityCorrection();
}


// ************************************************************************* //
