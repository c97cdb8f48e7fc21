// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonicExtension.H"
#include "calculatedPointPatchFields.H"
#include "fixedValueFvPatchFields.H"
#include "fvmLaplacian.H"
#include "fvMatrix.H"
#include "fvSchemes.H"
#include "limitedDiffusivity.H"
#include "pointFields.H"
#include "pointMesh.H"
#include "syncTools.H"
#include "volPointInterpolation.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Correction vectors that are shorter are rounding of an orthogonal mesh
constexpr scalar orthogonal = 1e-9;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::harmonicExtension::makeMesh
(
    const fvMesh& mesh,
    const pointField& points
)
{
    pointField ownPoints(points);
    faceList faces(mesh.faces());
    labelList owner(mesh.faceOwner());
    labelList neighbour(mesh.faceNeighbour());
    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                mesh.name(),
                mesh.time().constant(),
                mesh.time(),
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            std::move(ownPoints),
            std::move(faces),
            std::move(owner),
            std::move(neighbour)
        )
    );

    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    List<polyPatch*> copies(patches.size());
    forAll(patches, patchi)
    {
        copies[patchi] = patches[patchi].clone(mesh_->boundaryMesh()).ptr();
    }
    mesh_->addFvPatches(copies);

    fvSchemes& schemes = *mesh_;
    schemes.readOpt() = IOobject::MUST_READ;
    schemes.read();
}


void Foam::harmonicExtension::setDiffusivity(Istream& type)
{
    autoPtr<motionDiffusivity> chosen(motionDiffusivity::New(*mesh_, type));
    diffusivity_.reset(limitedDiffusivity(*chosen).ptr());
    // The scale of the equation, for floats
    *diffusivity_ /=
        gAverage
        (
            (
                diffusivity_->primitiveField()
               *mesh_->magSf().primitiveField()
               *mesh_->nonOrthDeltaCoeffs().primitiveField()
            )()
        );
}


Foam::volScalarField Foam::harmonicExtension::zeroField
(
    const List<condition>& conditions
) const
{
    const fvMesh& mesh = *mesh_;
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    wordList types(patches.types());
    forAll(types, patchi)
    {
        switch (conditions[patchi])
        {
            case condition::given:
            case condition::zero:
                types[patchi] = fixedValueFvPatchScalarField::typeName;
                break;

            case condition::zeroGradient:
                types[patchi] = zeroGradientFvPatchScalarField::typeName;
                break;

            case condition::ofPatch:
                break;
        }
    }

    // With the patches' own types as the third argument, because a condition
    // may differ from that of a patch such as symmetryPlane
    return volScalarField
    (
        IOobject
        (
            "harmonicExtension",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        types,
        patches.types()
    );
}


Foam::tmp<Foam::fvScalarMatrix> Foam::harmonicExtension::laplacian
(
    const volScalarField& onCells
) const
{
    return fvm::laplacian
    (
        *diffusivity_,
        onCells,
        "laplacian(diffusivity,cellDisplacement)"
    );
}


bool Foam::harmonicExtension::isCorrected() const
{
    const surfaceVectorField& corrections = mesh_->nonOrthCorrectionVectors();
    if (gMax(mag(corrections.primitiveField())()) <= orthogonal)
    {
        return false;
    }
    // What is explicit in the equation of a field whose gradient is not zero
    List<condition> conditions;
    for (const polyPatch& patch : mesh_->boundaryMesh())
    {
        conditions.append
        (
            polyPatch::constraintType(patch.type())
          ? condition::ofPatch
          : condition::zeroGradient
        );
    }
    volScalarField onCells(zeroField(conditions));
    for (direction axis = 0; axis < vector::nComponents; ++axis)
    {
        onCells.primitiveFieldRef() +=
            mesh_->C().primitiveField().component(axis);
    }
    return gMax(mag(laplacian(onCells)().source())()) > 0;
}


Foam::laplaceEquation& Foam::harmonicExtension::equation
(
    const List<condition>& conditions
) const
{
    if (!equation_.valid() || conditions_ != conditions)
    {
        equation_.clear();
        conditions_ = conditions;
        const volScalarField onCells(zeroField(conditions));
        equation_.reset
        (
            new laplaceEquation(laplacian(onCells)(), *faces_, fluxes_.get())
        );
    }
    return *equation_;
}


Foam::List<Foam::scalarBlock> Foam::harmonicExtension::onFaces
(
    const UList<scalarField>& onPoints,
    const List<condition>& conditions
) const
{
    const fvMesh& mesh = *mesh_;
    List<scalarBlock> values(mesh.nBoundaryFaces(), scalarBlock{});
    forAll(conditions, patchi)
    {
        if (conditions[patchi] == condition::given)
        {
            const polyPatch& patch = mesh.boundaryMesh()[patchi];
            forAll(patch, facei)
            {
                scalarBlock& block = values[patch.offset() + facei];
                forAll(onPoints, i)
                {
                    block[i] = patch[facei].average(mesh.points(), onPoints[i]);
                }
            }
        }
    }
    return values;
}


void Foam::harmonicExtension::setKnown
(
    scalarField& values,
    const scalarField& onPoints,
    const List<condition>& conditions
) const
{
    const fvMesh& mesh = *mesh_;
    bitSet isZero(mesh.nPoints());
    bitSet isGiven(mesh.nPoints());
    forAll(conditions, patchi)
    {
        const labelList& points = mesh.boundaryMesh()[patchi].meshPoints();
        if (conditions[patchi] == condition::zero)
        {
            isZero.set(points);
        }
        else if (conditions[patchi] == condition::given)
        {
            isGiven.set(points);
        }
    }
    // A rank may have a point of a patch and none of its faces
    syncTools::syncPointList(mesh, isZero, orEqOp<unsigned int>(), 0u);
    forAll(values, pointi)
    {
        if (isGiven[pointi])
        {
            values[pointi] = onPoints[pointi];
        }
        else if (isZero[pointi])
        {
            values[pointi] = 0;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::harmonicExtension::harmonicExtension
(
    const fvMesh& mesh,
    const pointField& points,
    Istream& diffusivity
)
{
    makeMesh(mesh, points);
    setDiffusivity(diffusivity);
    faces_.reset(new coupledFaces(*mesh_));
    if (isCorrected())
    {
        fluxes_.reset(new nonOrthogonalFluxes(*mesh_, *faces_, *diffusivity_));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::harmonicExtension::firstCellHeight
(
    const labelList& patches
) const
{
    scalar height = GREAT;
    for (const label patchi : patches)
    {
        // The first call computes them, which takes all ranks
        const scalarField& inverse = mesh_->boundary()[patchi].deltaCoeffs();
        if (inverse.size() > 0)
        {
            // From the face to the centre, and as much again
            height = min(height, 2/max(inverse));
        }
    }
    return returnReduce(height, minOp<scalar>());
}


Foam::scalarField Foam::harmonicExtension::toPoints
(
    volScalarField& onCells
) const
{
    wordList types(mesh_->boundaryMesh().types());
    for (word& type : types)
    {
        if (!polyPatch::constraintType(type))
        {
            type = calculatedPointPatchScalarField::typeName;
        }
    }
    pointScalarField extended
    (
        IOobject(onCells),
        pointMesh::New(*mesh_),
        dimensionedScalar(dimless, Zero),
        types
    );
    onCells.correctBoundaryConditions();
    volPointInterpolation::New(*mesh_).interpolate(onCells, extended);
    return scalarField(extended.primitiveField());
}


Foam::List<Foam::scalarField> Foam::harmonicExtension::extend
(
    const UList<scalarField>& onPoints,
    const List<condition>& conditions
) const
{
    const List<scalarBlock> given(onFaces(onPoints, conditions));
    const List<scalarBlock> solution(equation(conditions).solve(given));
    List<scalarField> extended(onPoints.size());
    volScalarField onCells(zeroField(conditions));
    forAll(onPoints, i)
    {
        forAll(solution, celli)
        {
            onCells.primitiveFieldRef()[celli] = solution[celli][i];
        }
        forAll(conditions, patchi)
        {
            if (conditions[patchi] == condition::given)
            {
                fvPatchScalarField& onPatch =
                    onCells.boundaryFieldRef()[patchi];
                forAll(onPatch, facei)
                {
                    onPatch[facei] =
                        given[onPatch.patch().patch().offset() + facei][i];
                }
            }
        }
        extended[i] = toPoints(onCells);
        setKnown(extended[i], onPoints[i], conditions);
    }
    return extended;
}


// ************************************************************************* //
