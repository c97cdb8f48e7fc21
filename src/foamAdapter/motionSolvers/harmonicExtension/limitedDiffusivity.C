// SPDX-License-Identifier: GPL-3.0-or-later
#include "limitedDiffusivity.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::limitedDiffusivity
(
    motionDiffusivity& diffusivity
)
{
    diffusivity.correct();
    tmp<surfaceScalarField> limited
    (
        dimensionedScalar("viscosity", dimViscosity, 1)*diffusivity()
    );

    const scalar limit = 10*gMax(limited().primitiveField());
    for (fvsPatchScalarField& onPatch : limited.ref().boundaryFieldRef())
    {
        if (!onPatch.coupled())
        {
            onPatch = min(onPatch, limit);
        }
    }
    return limited;
}


// ************************************************************************* //
