/*---------------------------------------------------------------------------*\
    Tokay: OpenFOAM coupled to an isogeometric structure
-------------------------------------------------------------------------------
License
    This file is part of Tokay, which is free software: you can redistribute
    it and/or modify it under the terms of the GNU General Public License as
    published by the Free Software Foundation, either version 3 of the
    License, or (at your option) any later version. See the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "powerDiffusivity.H"
#include "addToRunTimeSelectionTable.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(powerDiffusivity, 0);

    addToRunTimeSelectionTable(motionDiffusivity, powerDiffusivity, Istream);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::powerDiffusivity::readExponent(Istream& data)
{
    const token exponent(data);
    if (!exponent.isNumber() || exponent.number() < 0)
    {
        FatalIOErrorInFunction(data)
            << "the exponent of the diffusivity 'power' is " << exponent
            << "; it must be a number, not negative"
            << exit(FatalIOError);
    }
    return exponent.number();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::powerDiffusivity::powerDiffusivity(const fvMesh& mesh, Istream& data)
:
    motionDiffusivity(mesh),
    exponent_(readExponent(data)),
    base_(motionDiffusivity::New(mesh, data))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::powerDiffusivity::operator()() const
{
    return pow(base_->operator()(), exponent_);
}


void Foam::powerDiffusivity::correct()
{
    base_->correct();
}


// ************************************************************************* //
