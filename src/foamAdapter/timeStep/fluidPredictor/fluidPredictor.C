// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluidPredictor.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::fluidPredictor::choice>
Foam::fluidPredictor::choiceNames
({
    {choice::none, "none"},
    {choice::linear, "linear"}
});

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Pressure that a solver solves for
word solvedPressure(const fvMesh& mesh, const word& pName)
{
    return mesh.foundObject<volScalarField>("p_rgh") ? word("p_rgh") : pName;
}


//- Whether there are fractions of volume. They jump, and with them what would
//  be extrapolated
bool hasPhases(const fvMesh& mesh)
{
    for (const word& name : mesh.names<volScalarField>())
    {
        if (name.starts_with("alpha."))
        {
            return true;
        }
    }
    return false;
}


//- Extrapolate values by a factor, and keep what they were
template<class Type>
void extrapolate
(
    Field<Type>& values,
    Field<Type>& previous,
    const scalar factor
)
{
    forAll(values, i)
    {
        const Type present(values[i]);
        values[i] += factor*(present - previous[i]);
        previous[i] = present;
    }
}


//- The same of a field. Other than on cells, the boundary has values of its own
void extrapolate
(
    surfaceScalarField& field,
    surfaceScalarField& previous,
    const scalar factor
)
{
    extrapolate
    (
        field.primitiveFieldRef(),
        previous.primitiveFieldRef(),
        factor
    );
    auto& patches = field.boundaryFieldRef();
    forAll(patches, patchi)
    {
        extrapolate<scalar>
        (
            patches[patchi],
            previous.boundaryFieldRef()[patchi],
            factor
        );
    }
}


template<class Type>
void extrapolate
(
    GeometricField<Type, fvPatchField, volMesh>& field,
    GeometricField<Type, fvPatchField, volMesh>& previous,
    const scalar factor
)
{
    extrapolate
    (
        field.primitiveFieldRef(),
        previous.primitiveFieldRef(),
        factor
    );
    field.correctBoundaryConditions();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::fluidPredictor::previousOf(const word& name) const
{
    return IOobject
    (
        name + "_previous",
        mesh_.time().timeName(),
        mesh_,
        IOobject::NO_READ,
        IOobject::AUTO_WRITE
    );
}


template<class GeoField>
void Foam::fluidPredictor::read
(
    const word& name,
    autoPtr<GeoField>& previous
) const
{
    IOobject file(previousOf(name));
    const bool isThere = file.typeHeaderOk<GeoField>(true);
    if (returnReduce(isThere, andOp<bool>()))
    {
        file.readOpt() = IOobject::MUST_READ;
        previous.reset(new GeoField(file, mesh_));
    }
}


template<class GeoField>
void Foam::fluidPredictor::predict
(
    const word& name,
    autoPtr<GeoField>& previous
) const
{
    if (previous.valid())
    {
        const Time& time = mesh_.time();
        GeoField& field = mesh_.lookupObjectRef<GeoField>(name);
        // After a restart the solver asks for it later, and would get the
        // prediction
        field.oldTime();
        extrapolate
        (
            field,
            *previous,
            time.deltaTValue()/time.deltaT0Value()
        );
    }
    // What a run starts from is no solution to extrapolate
    else if (mesh_.time().timeIndex() > mesh_.time().startTimeIndex() + 1)
    {
        const GeoField& field = mesh_.lookupObject<GeoField>(name);
        previous.reset
        (
            new GeoField
            (
                previousOf(name),
                mesh_,
                dimensioned<typename GeoField::value_type>
                (
                    field.dimensions(), Zero
                )
            )
        );
        *previous == field;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidPredictor::fluidPredictor
(
    const dictionary& dict,
    const fvMesh& mesh,
    const word& pName,
    const word& UName,
    const bool strong
)
:
    mesh_(mesh),
    choice_
    (
        !strong
      ? choice::none
      : readChoice
        (
            "fluidPredictor",
            dict,
            choiceNames,
            hasPhases(mesh) ? choice::none : choice::linear
        )
    ),
    pName_(solvedPressure(mesh, pName)),
    UName_(UName)
{
    if (choice_ == choice::linear)
    {
        read(pName_, p_);
        read(UName_, U_);
        read("phi", phi_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fluidPredictor::announce() const
{
    if (choice_ == choice::linear)
    {
        Info<< "    fluidPredictor linear: a time step starts from "
            << "extrapolated " << pName_ << ", " << UName_ << " and phi"
            << endl;
    }
}


void Foam::fluidPredictor::beginTimeStep()
{
    if (choice_ == choice::linear)
    {
        predict(pName_, p_);
        predict(UName_, U_);
        predict("phi", phi_);
    }
}


// ************************************************************************* //
