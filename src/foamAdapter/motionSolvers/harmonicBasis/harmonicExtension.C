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

//- Tolerance of the linear solver, for the normalised residual: the functions
//  are solved once, so there is no reason to save here
constexpr scalar tightTolerance = 1e-12;

//- Enough passes over the explicit part of non-orthogonal meshes
constexpr label largestPasses = 30;
constexpr scalar passTolerance = 1e-8;

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
}


Foam::volScalarField Foam::harmonicExtension::field
(
    const scalarField& onPoints,
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
    volScalarField onCells
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
    forAll(conditions, patchi)
    {
        if (conditions[patchi] == condition::given)
        {
            const polyPatch& patch = patches[patchi];
            fvPatchScalarField& onFaces = onCells.boundaryFieldRef()[patchi];
            forAll(patch, facei)
            {
                onFaces[facei] =
                    patch[facei].average(mesh.points(), onPoints);
            }
        }
    }
    return onCells;
}


void Foam::harmonicExtension::solve(volScalarField& onCells) const
{
    const int verbosity = solverPerformance::debug;
    solverPerformance::debug = 0;
    for (label pass = 0; pass < largestPasses; ++pass)
    {
        fvScalarMatrix equation
        (
            fvm::laplacian
            (
                *diffusivity_,
                onCells,
                "laplacian(diffusivity,cellDisplacement)"
            )
        );
        if (equation.solve(solver_).initialResidual() < passTolerance)
        {
            break;
        }
    }
    solverPerformance::debug = verbosity;
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
    solver_.add("solver", word("PCG"));
    solver_.add("preconditioner", word("DIC"));
    solver_.add("tolerance", tightTolerance);
    solver_.add("relTol", 0);
    solver_.add("maxIter", 10000);
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


Foam::scalarField Foam::harmonicExtension::extend
(
    const scalarField& onPoints,
    const List<condition>& conditions
) const
{
    volScalarField onCells(field(onPoints, conditions));
    solve(onCells);

    const polyBoundaryMesh& patches = mesh_->boundaryMesh();
    wordList types(patches.types());
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
    volPointInterpolation::New(*mesh_).interpolate(onCells, extended);
    scalarField values(extended.primitiveField());
    setKnown(values, onPoints, conditions);
    return values;
}


// ************************************************************************* //
