// SPDX-License-Identifier: GPL-3.0-or-later
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
