/*---------------------------------------------------------------------------*\
    Tokay: OpenFOAM coupled to an isogeometric structure
-------------------------------------------------------------------------------
License
    This file is part of Tokay, which is free software: you can redistribute
    it and/or modify it under the terms of the GNU General Public License as
    published by the Free Software Foundation, either version 3 of the
    License, or (at your option) any later version. See the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "structureDisplacementPointPatchVectorField.H"
#include "couplingSession.H"
#include "addToRunTimeSelectionTable.H"
#include "pointPatchFields.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::structureDisplacementPointPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const fvMesh& mesh = refCast<const fvMesh>(internalField().mesh()());
    couplingSession* session = couplingSession::find(mesh, patch().index());
    if (!session)
    {
        FatalErrorInFunction
            << "patch '" << patch().name() << "' has the condition '" << type()
            << "' but no function object 'structureCoupling' couples it" << nl
            << "    add one with this patch to system/controlDict"
            << exit(FatalError);
    }
    operator==(session->displacement(patch().index()));

    base::updateCoeffs();
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePointPatchTypeField
    (
        pointPatchVectorField,
        structureDisplacementPointPatchVectorField
    );
}


// ************************************************************************* //
