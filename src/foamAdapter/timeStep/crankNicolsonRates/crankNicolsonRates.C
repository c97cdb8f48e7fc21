// SPDX-License-Identifier: GPL-3.0-or-later
#include "crankNicolsonRates.H"
#include "fvcMeshPhi.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Name of the rate of the mesh's fluxes
const char* const meshFluxRate = "meshPhiCN_0";

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class GeoField>
bool Foam::crankNicolsonRates::keep(regIOobject& rate)
{
    GeoField* field = dynamic_cast<GeoField*>(&rate);
    if (field && field->nOldTimes() == 0)
    {
        field->oldTime();
        field->timeIndex() = field->time().timeIndex();
    }
    return field;
}


template<class Type>
bool Foam::crankNicolsonRates::keepAny(regIOobject& rate)
{
    return
        keep<GeometricField<Type, fvPatchField, volMesh>>(rate)
     || keep<GeometricField<Type, fvsPatchField, surfaceMesh>>(rate);
}


void Foam::crankNicolsonRates::keepMeshFluxes() const
{
    const surfaceScalarField& phi = mesh_.phi();
    if (phi.nOldTimes() == 0)
    {
        phi.oldTime();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::crankNicolsonRates::crankNicolsonRates
(
    const fvMesh& mesh,
    const word& UName
)
:
    mesh_(mesh),
    UName_(UName)
{
    // Read at a restart
    if (mesh_.moving())
    {
        keepMeshFluxes();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::crankNicolsonRates::isRate(const word& name)
{
    return
        name == meshFluxRate
     || (
            (name.starts_with("ddt0(") || name.starts_with("ddtCorrDdt0("))
         && !name.ends_with("_0") // the old time that a rate has been given
        );
}


void Foam::crankNicolsonRates::beginTimeStep()
{
    const Time& runTime = mesh_.time();

    // The first step of all has none; the first after a restart reads it
    const bool exists =
        mesh_.foundObject<surfaceScalarField>(meshFluxRate)
     || (
            mesh_.moving()
         && runTime.timeIndex() == runTime.startTimeIndex() + 1
         && IOobject
            (
                meshFluxRate,
                runTime.timeName(runTime.startTime().value()),
                mesh_
            ).typeHeaderOk<surfaceScalarField>(true)
        );

    if (exists)
    {
        fvc::meshPhi(mesh_.lookupObject<volVectorField>(UName_));
    }
    if (mesh_.foundObject<surfaceScalarField>(meshFluxRate))
    {
        mesh_.lookupObjectRef<surfaceScalarField>(meshFluxRate).timeIndex() =
            runTime.timeIndex();
    }
}


void Foam::crankNicolsonRates::keepNew() const
{
    if (mesh_.foundObject<surfaceScalarField>(meshFluxRate))
    {
        keepMeshFluxes();
    }
    // Not while running through the registry: an old time is registered too
    DynamicList<regIOobject*> rates;
    forAllConstIters(mesh_.thisDb(), iter)
    {
        if (isRate(iter.key()) && iter.key() != meshFluxRate)
        {
            rates.append(iter.val());
        }
    }
    for (regIOobject* rate : rates)
    {
        keepAny<scalar>(*rate)
     || keepAny<vector>(*rate)
     || keepAny<sphericalTensor>(*rate)
     || keepAny<symmTensor>(*rate)
     || keepAny<tensor>(*rate);
    }
}


// ************************************************************************* //
