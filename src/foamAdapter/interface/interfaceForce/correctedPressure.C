// SPDX-License-Identifier: GPL-3.0-or-later
#include "correctedPressure.H"
#include "findRefCell.H"
#include "fixedGradientFvPatchFields.H"
#include "fluidThermo.H"
#include "fvcVolumeIntegrate.H"
#include "pimpleControl.H"
#include "rhoThermo.H"
#include "uniformDimensionedFields.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::correctedPressure::solved Foam::correctedPressure::findSolved() const
{
    if (name_ != "p")
    {
        return solved::p;
    }
    if (mesh_.foundObject<volScalarField>("p_gh"))
    {
        return solved::p_gh;
    }
    if (!mesh_.foundObject<volScalarField>("p_rgh"))
    {
        return solved::p;
    }
    return mesh_.sortedNames<rhoThermo>().size() > 1
      ? solved::mixture
      : solved::p_rgh;
}


const Foam::volScalarField& Foam::correctedPressure::field
(
    const word& name
) const
{
    return mesh_.lookupObject<volScalarField>(name);
}


Foam::tmp<Foam::scalarField> Foam::correctedPressure::density
(
    const label patchi
) const
{
    if (solved_ != solved::mixture)
    {
        return field("rho").boundaryField()[patchi];
    }
    const scalarField change
    (
        field("p_rgh").boundaryField()[patchi] - p_rgh0_[patchi]
    );
    tmp<scalarField> density(new scalarField(change.size(), Zero));
    for (const word& name : mesh_.sortedNames<rhoThermo>())
    {
        const rhoThermo& thermo = mesh_.lookupObject<rhoThermo>(name);
        const word alphaName(IOobject::groupName("alpha", thermo.group()));
        density.ref() +=
            field(alphaName).boundaryField()[patchi]
           *(
                thermo.rho(patchi)
              + thermo.psi().boundaryField()[patchi]*change
            );
    }
    return density;
}


Foam::scalar Foam::correctedPressure::shift() const
{
    if (solved_ != solved::p_rgh || !field("p_rgh").needReference())
    {
        return 0;
    }
    const scalarField p
    (
        field("p_rgh").primitiveField()
      + field("rho").primitiveField()*field("gh").primitiveField()
    );
    if (mesh_.foundObject<fluidThermo>(fluidThermo::dictName))
    {
        const scalarField psiV
        (
            mesh_.lookupObject<fluidThermo>(fluidThermo::dictName)
           .psi().primitiveField()
           *mesh_.V()
        );
        const scalar compressibility = gSum(psiV);
        if (compressibility > SMALL)
        {
            return (initialMass_ - gSum(psiV*p))/compressibility;
        }
    }
    const scalar present = refCell_ >= 0 ? p[refCell_] : 0;
    return refValue_ - returnReduce(present, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::correctedPressure::correctedPressure
(
    const fvMesh& mesh,
    const word& name
)
:
    mesh_(mesh),
    name_(name),
    solved_(findSolved()),
    refCell_(-1),
    refValue_(0),
    initialMass_(0),
    pMin_(0)
{
    if (solved_ == solved::p_rgh && field("p_rgh").needReference())
    {
        setRefCell
        (
            field("p"),
            field("p_rgh"),
            mesh.lookupObject<pimpleControl>("solutionControl").dict(),
            refCell_,
            refValue_
        );
        initialMass_ = fvc::domainIntegrate(field("rho")).value();
    }
    if (solved_ == solved::mixture)
    {
        pMin_ = dimensionedScalar
        (
            "pMin",
            dimPressure,
            mesh.lookupObject<IOdictionary>(basicThermo::dictName)
        ).value();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::correctedPressure::beginTimeStep()
{
    if (solved_ == solved::mixture)
    {
        const auto& p_rgh = field("p_rgh").boundaryField();
        p_rgh0_.setSize(p_rgh.size());
        forAll(p_rgh, patchi)
        {
            p_rgh0_[patchi] = p_rgh[patchi];
        }
    }
}


void Foam::correctedPressure::endPressureCorrector()
{
    beginTimeStep();
    forAll(p_rgh0_, patchi)
    {
        // The solver evaluates its conditions once more after the fvOptions
        const fvPatchScalarField& p_rgh =
            field("p_rgh").boundaryField()[patchi];
        if (isA<fixedGradientFvPatchScalarField>(p_rgh))
        {
            p_rgh0_[patchi] =
                p_rgh.patchInternalField()
              + refCast<const fixedGradientFvPatchScalarField>(p_rgh).gradient()
               /p_rgh.patch().deltaCoeffs();
        }
        else if (isA<zeroGradientFvPatchScalarField>(p_rgh))
        {
            p_rgh0_[patchi] = p_rgh.patchInternalField();
        }
    }
}


Foam::List<Foam::scalarField> Foam::correctedPressure::operator()
(
    const labelList& patches
) const
{
    List<scalarField> p(patches.size());
    const scalar shift = this->shift();
    forAll(patches, i)
    {
        const label patchi = patches[i];
        switch (solved_)
        {
            case solved::p:
                p[i] = field(name_).boundaryField()[patchi];
                break;

            case solved::p_gh:
                p[i] =
                    field("p_gh").boundaryField()[patchi]
                  + (
                        mesh_.time().lookupObject
                        <
                            uniformDimensionedVectorField
                        >("g").value()
                      & mesh_.boundary()[patchi].Cf()
                    );
                break;

            case solved::p_rgh:
            case solved::mixture:
                p[i] =
                    field("p_rgh").boundaryField()[patchi]
                  + density(patchi)*field("gh").boundaryField()[patchi]
                  + shift;
                break;
        }
        if (solved_ == solved::mixture)
        {
            p[i] = max(p[i], pMin_);
        }
    }
    return p;
}


// ************************************************************************* //
