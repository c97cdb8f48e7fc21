/*---------------------------------------------------------------------------*\
    Tokay: OpenFOAM coupled to an isogeometric structure
-------------------------------------------------------------------------------
License
    This file is part of Tokay, which is free software: you can redistribute
    it and/or modify it under the terms of the GNU General Public License as
    published by the Free Software Foundation, either version 3 of the
    License, or (at your option) any later version. See the file LICENSE.

\*---------------------------------------------------------------------------*/

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
