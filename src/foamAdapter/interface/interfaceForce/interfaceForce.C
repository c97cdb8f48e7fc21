// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaceForce.H"
#include "basicThermo.H"
#include "fvcGrad.H"
#include "openfoamVersion.H"
#include "turbulentTransportModel.H"
#include "turbulentFluidThermoModel.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::interfaceForce::findPressure
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const word pName(dict.lookupOrDefault<word>("p", "p"));
    const word UName(dict.lookupOrDefault<word>("U", "U"));
    if
    (
        !mesh.foundObject<volScalarField>(pName)
     || !mesh.foundObject<volVectorField>(UName)
    )
    {
        FatalIOErrorInFunction(dict)
            << "no pressure field '" << pName << "' or no velocity field '"
            << UName << "' in this solver; name them by the entries 'p' and "
            << "'U'. There are: " << mesh.sortedNames<volScalarField>() << ' '
            << mesh.sortedNames<volVectorField>() << exit(FatalIOError);
    }
    return pName;
}


Foam::tmp<Foam::scalarField> Foam::interfaceForce::viscosity
(
    const label patchi
) const
{
    typedef compressible::turbulenceModel compressibleModel;
    typedef incompressible::turbulenceModel incompressibleModel;

    if
    (
        mesh_.foundObject<compressibleModel>(compressibleModel::propertiesName)
    )
    {
        return mesh_.lookupObject<compressibleModel>
        (
            compressibleModel::propertiesName
        ).muEff(patchi);
    }

    tmp<scalarField> nuEff
    (
        mesh_.lookupObject<incompressibleModel>
        (
            incompressibleModel::propertiesName
        ).nuEff(patchi)
    );
    if (kinematic_)
    {
        return rho_*nuEff;
    }
    // Several incompressible phases
    return
        mesh_.lookupObject<volScalarField>("rho").boundaryField()[patchi]
       *nuEff;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceForce::interfaceForce
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    UName_(dict.lookupOrDefault<word>("U", "U")),
    pressure_(mesh, findPressure(mesh, dict)),
    kinematic_(pressure_.solverField().dimensions() != dimPressure),
    rho_(1),
    pRef_(dict.lookupOrDefault<scalar>("pRef", 0)),
    viscous_(dict.lookupOrDefault("viscous", true))
{
    if (kinematic_)
    {
        rho_ = dict.get<scalar>("rho");
        if (rho_ <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "the density 'rho' is " << rho_
                << " kg/m3: it must be positive" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::interfaceForce::reportAbsolute
(
    const labelList& patches,
    const dictionary& dict
) const
{
    if
    (
        dict.found("pRef")
     || !mesh_.foundObject<basicThermo>(basicThermo::dictName)
    )
    {
        return;
    }
    scalar area = 0;
    scalar force = 0;
    for (const label patchi : patches)
    {
        const scalarField& magSf = mesh_.magSf().boundaryField()[patchi];
        area += sum(magSf);
        force += sum
        (
            magSf*pressure_.solverField().boundaryField()[patchi]
        );
    }
    reduce(area, sumOp<scalar>());
    reduce(force, sumOp<scalar>());
    const scalar mean = force/area;
    IOWarningInFunction(dict)
        << "the pressure of this solver is absolute, " << mean
        << " Pa on the coupled patches at the start, and there is no 'pRef': "
        << "all of it acts on the structure, " << force << " N on " << area
        << " m2" << nl
        << "    add 'pRef " << mean << ";', the pressure behind the structure, "
        << "or 'pRef 0;' if that is a vacuum" << endl;
}


Foam::vectorField Foam::interfaceForce::operator()
(
    const labelList& patches
) const
{
    const List<scalarField> p(pressure_(patches));

    tmp<volTensorField> gradU;
    if (viscous_)
    {
        gradU = fvc::grad(mesh_.lookupObject<volVectorField>(UName_));
    }

    DynamicList<vector> forces;
    forAll(patches, i)
    {
        const label patchi = patches[i];
        const vectorField& Sf = mesh_.Sf().boundaryField()[patchi];
        vectorField force(Sf*(rho_*p[i] - pRef_));
        if (viscous_)
        {
            force -=
                Sf
              & (
                    viscosity(patchi)
                   *dev(twoSymm(gradU().boundaryField()[patchi]))
                );
        }
        forces.append(force);
    }

    return vectorField(std::move(forces));
}


Foam::string Foam::interfaceForce::describeNonFinite
(
    const labelList& patches,
    const vectorField& forces
) const
{
    List<string> texts(Pstream::nProcs());
    string& own = texts[Pstream::myProcNo()];
    label facei = 0;
    for (const label patchi : patches)
    {
        for (const point& centre : mesh_.boundary()[patchi].Cf())
        {
            const vector& force = forces[facei++];
            if (own.empty() && !std::isfinite(cmptSum(force)))
            {
                OStringStream os;
                os  << "the fluid's force is not finite: " << force
                    << " N on patch '" << mesh_.boundary()[patchi].name()
                    << "' at " << centre << ", time "
                    << mesh_.time().timeName()
                    << " s. The flow has diverged";
                own = os.str();
            }
        }
    }
    shareAmongRanks(texts);
    for (const string& text : texts)
    {
        if (!text.empty())
        {
            return text;
        }
    }
    return string();
}


// ************************************************************************* //
