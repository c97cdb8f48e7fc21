// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacementSource.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(displacementSource, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::displacementSource::displacementSource
(
    const word& name,
    const fvMesh& mesh
)
:
    regIOobject
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::displacementSource* Foam::displacementSource::find
(
    const fvMesh& mesh,
    const label patchi
)
{
    for (const word& name : mesh.sortedNames<displacementSource>())
    {
        displacementSource& source =
            mesh.lookupObjectRef<displacementSource>(name);

        if (source.patches().found(patchi))
        {
            return &source;
        }
    }
    return nullptr;
}


// ************************************************************************* //
