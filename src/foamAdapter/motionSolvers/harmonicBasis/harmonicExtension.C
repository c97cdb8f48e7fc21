// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonicExtension.H"
#include "fixedValueFvPatchFields.H"
#include "fixedValuePointPatchFields.H"
#include "fvmLaplacian.H"
#include "fvMatrix.H"
#include "fvSchemes.H"
#include "limitedDiffusivity.H"
#include "pointMesh.H"
#include "slipPointPatchFields.H"
#include "volFields.H"
#include "volPointInterpolation.H"
#include "zeroGradientFvPatchFields.H"
#include "calculatedPointPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of the linear solver, relative to the normalised residual: the functions are
//  solved once, so there is no reason to save here
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


void Foam::harmonicExtension::setConditions
(
    const pointVectorField& displacement
)
{
    const fvBoundaryMesh& patches = mesh_->boundary();
    faceTypes_.setSize(patches.size());
    pointTypes_.setSize(patches.size());
    labelHashSet fixedPoints;
    forAll(patches, patchi)
    {
        const pointPatchVectorField& condition =
            displacement.boundaryField()[patchi];
        const bool moves = patches_.found(patchi);
        const bool isFixed =
            isA<fixedValuePointPatchVectorField>(condition)
         || isA<slipPointPatchVectorField>(condition);
        if (polyPatch::constraintType(patches[patchi].type()))
        {
            faceTypes_[patchi] = patches[patchi].type();
            pointTypes_[patchi] = patches[patchi].type();
        }
        else if (moves || isFixed)
        {
            faceTypes_[patchi] = fixedValueFvPatchScalarField::typeName;
            pointTypes_[patchi] = fixedValuePointPatchScalarField::typeName;
        }
        else
        {
            faceTypes_[patchi] = zeroGradientFvPatchScalarField::typeName;
            pointTypes_[patchi] = calculatedPointPatchScalarField::typeName;
        }
        if (isFixed && !moves)
        {
            fixedPoints.insert(patches[patchi].patch().meshPoints());
        }
    }
    fixedPoints_ = fixedPoints.sortedToc();
}


void Foam::harmonicExtension::setDiffusivity(Istream& type)
{
    autoPtr<motionDiffusivity> chosen(motionDiffusivity::New(*mesh_, type));
    diffusivity_.reset(limitedDiffusivity(*chosen).ptr());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::harmonicExtension::harmonicExtension
(
    const fvMesh& mesh,
    const pointField& points,
    const pointVectorField& displacement,
    const labelList& patches,
    Istream& diffusivity
)
:
    patches_(patches)
{
    makeMesh(mesh, points);
    setConditions(displacement);
    setDiffusivity(diffusivity);
    solver_.add("solver", word("PCG"));
    solver_.add("preconditioner", word("DIC"));
    solver_.add("tolerance", tightTolerance);
    solver_.add("relTol", 0);
    solver_.add("maxIter", 10000);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::harmonicExtension::firstCellHeight() const
{
    scalar height = GREAT;
    for (const label patchi : patches_)
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
    const scalarField& onPoints
) const
{
    const fvMesh& mesh = *mesh_;
    const IOobject io
    (
        "harmonicExtension",
        mesh.time().timeName(),
        mesh,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
    volScalarField onCells
    (
        io,
        mesh,
        dimensionedScalar(dimless, Zero),
        faceTypes_
    );
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        fvPatchScalarField& onFaces = onCells.boundaryFieldRef()[patchi];
        forAll(patch, facei)
        {
            onFaces[facei] = patch[facei].average(mesh.points(), onPoints);
        }
    }

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

    pointScalarField extended
    (
        io,
        pointMesh::New(mesh),
        dimensionedScalar(dimless, Zero),
        pointTypes_
    );
    volPointInterpolation::New(mesh).interpolate(onCells, extended);
    scalarField values(extended.primitiveField());
    UIndirectList<scalar>(values, fixedPoints_) = 0;
    for (const label patchi : patches_)
    {
        for (const label pointi : mesh.boundaryMesh()[patchi].meshPoints())
        {
            values[pointi] = onPoints[pointi];
        }
    }
    return values;
}


// ************************************************************************* //
