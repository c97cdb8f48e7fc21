// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaceForce.H"
#include "basicThermo.H"
#include "fvcGrad.H"
#include "openfoamVersion.H"
#include "turbulentTransportModel.H"
#include "turbulentFluidThermoModel.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Whether the gradient of a field is by Gauss' theorem with linear
//  interpolation
bool isGaussLinear(const volVectorField& field)
{
    ITstream& scheme = field.mesh().gradScheme("grad(" + field.name() + ')');
    if (word(scheme) != "Gauss")
    {
        return false;
    }
    return
        scheme.nRemainingTokens() == 0
     || (scheme.nRemainingTokens() == 1 && word(scheme) == "linear");
}


//- Values of a field on the faces of all patches, by linear interpolation
List<vectorField> onPatchFaces(const volVectorField& field)
{
    const surfaceScalarField& weights = field.mesh().weights();
    List<vectorField> values(field.boundaryField().size());
    forAll(values, patchi)
    {
        const fvPatchVectorField& patch = field.boundaryField()[patchi];
        if (patch.coupled())
        {
            const scalarField& w = weights.boundaryField()[patchi];
            values[patchi] =
                w*patch.patchInternalField()
              + (1.0 - w)*patch.patchNeighbourField();
        }
        else
        {
            values[patchi] = patch;
        }
    }
    return values;
}


//- Gradient in a cell by Gauss' theorem with linear interpolation
//  \param onPatches  values of the field on the faces of all patches
tensor cellGradient
(
    const volVectorField& field,
    const List<vectorField>& onPatches,
    const label celli
)
{
    const fvMesh& mesh = field.mesh();
    // In the order of fvc::grad: the sums are the same to the last digit
    labelList faces(mesh.cells()[celli]);
    sort(faces);
    tensor sum(Zero);
    for (const label facei : faces)
    {
        if (mesh.isInternalFace(facei))
        {
            const vector& own = field[mesh.owner()[facei]];
            const vector& nei = field[mesh.neighbour()[facei]];
            const tensor part
            (
                mesh.Sf()[facei]*(mesh.weights()[facei]*(own - nei) + nei)
            );
            mesh.owner()[facei] == celli ? sum += part : sum -= part;
            continue;
        }
        const label patchi = mesh.boundaryMesh().whichPatch(facei);
        const label patchFacei = mesh.boundaryMesh()[patchi].whichFace(facei);
        // Patches of empty directions have none
        if (patchFacei < onPatches[patchi].size())
        {
            sum +=
                mesh.Sf().boundaryField()[patchi][patchFacei]
               *onPatches[patchi][patchFacei];
        }
    }
    return sum/mesh.V()[celli];
}


//- Gradients of a field on the faces of patches: those of the cells there, with
//  the normal derivative of the patch
List<tensorField> gradients
(
    const volVectorField& field,
    const labelList& patches
)
{
    List<tensorField> gradients(patches.size());
    if (!isGaussLinear(field))
    {
        const tmp<volTensorField> ofAll(fvc::grad(field));
        forAll(patches, i)
        {
            gradients[i] = ofAll().boundaryField()[patches[i]];
        }
        return gradients;
    }
    const List<vectorField> onPatches(onPatchFaces(field));
    forAll(patches, i)
    {
        const fvPatch& patch = field.mesh().boundary()[patches[i]];
        tensorField& ofPatch = gradients[i];
        ofPatch.setSize(patch.size());
        forAll(ofPatch, facei)
        {
            ofPatch[facei] =
                cellGradient(field, onPatches, patch.faceCells()[facei]);
        }
        const vectorField n(patch.nf());
        ofPatch +=
            n
           *(
                field.boundaryField()[patches[i]].snGrad()
              - (n & ofPatch)
            );
    }
    return gradients;
}

} // End anonymous namespace

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

    List<tensorField> gradU;
    if (viscous_)
    {
        gradU = gradients(mesh_.lookupObject<volVectorField>(UName_), patches);
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
                   *dev(twoSymm(gradU[i]))
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
