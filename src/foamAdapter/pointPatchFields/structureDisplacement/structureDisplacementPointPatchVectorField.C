// SPDX-License-Identifier: GPL-3.0-or-later
#include "structureDisplacementPointPatchVectorField.H"
#include "displacementSource.H"
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
    displacementSource* const source =
        displacementSource::find(mesh, patch().index());
    if (!source)
    {
        FatalErrorInFunction
            << "patch '" << patch().name() << "' has the condition '" << type()
            << "' but no function object 'structureCoupling' couples it" << nl
            << "    add one with this patch to system/controlDict"
            << exit(FatalError);
    }
    operator==(source->displacement(patch().index()));

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
