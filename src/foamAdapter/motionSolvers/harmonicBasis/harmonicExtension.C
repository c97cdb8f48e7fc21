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

//- Tolerance of a field for the normalised residual. A field that is a little
//  off is as smooth, and the mesh moves by the same one to the end of the run
constexpr scalar tolerance = 1e-9;

//- Enough passes over the explicit part of non-orthogonal meshes, what each has
//  to gain, and what the last may leave
constexpr label maxPasses = 30;
constexpr scalar passGain = 0.1;
constexpr scalar passTolerance = 1e-6;

//- Controls of the linear solver
static dictionary controls(const scalar relTol)
{
    dictionary controls;
    controls.add("solver", word("GAMG"));
    controls.add("smoother", word("GaussSeidel"));
    controls.add("tolerance", tolerance);
    controls.add("relTol", relTol);
    controls.add("maxIter", 1000);
    return controls;
}

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


Foam::harmonicExtension::laplaceEquation&
Foam::harmonicExtension::equation(const List<condition>& conditions) const
{
    if (!equation_.valid() || equation_->conditions != conditions)
    {
        equation_.clear();
        equation_.reset(new laplaceEquation(*this, conditions));
    }
    return *equation_;
}


void Foam::harmonicExtension::setBoundary
(
    laplaceEquation& equation,
    const scalarField& onPoints
) const
{
    const fvMesh& mesh = *mesh_;
    forAll(equation.conditions, patchi)
    {
        if (equation.conditions[patchi] == condition::given)
        {
            const polyPatch& patch = mesh.boundaryMesh()[patchi];
            fvPatchScalarField& onFaces =
                equation.onCells.boundaryFieldRef()[patchi];
            forAll(patch, facei)
            {
                onFaces[facei] =
                    patch[facei].average(mesh.points(), onPoints);
            }
            // As it enters the equation of the cell beside it
            equation.matrix.boundaryCoeffs()[patchi] =
                equation.matrix.internalCoeffs()[patchi]*onFaces;
        }
    }
}


void Foam::harmonicExtension::solve(laplaceEquation& equation) const
{
    const int verbosity = solverPerformance::debug;
    solverPerformance::debug = 0;
    equation.onCells.primitiveFieldRef() = 0;
    equation.matrix.source() = 0;
    const dictionary inPass(controls(isCorrected_ ? passGain : 0));
    for (label pass = 0; pass < maxPasses; ++pass)
    {
        const scalar residual =
            equation.solver->solve(inPass).initialResidual();
        if (residual < passTolerance || !isCorrected_)
        {
            break;
        }
        equation.matrix.source() = laplacian(equation.onCells)().source();
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

Foam::harmonicExtension::laplaceEquation::laplaceEquation
(
    const harmonicExtension& extension,
    const List<condition>& theConditions
)
:
    conditions(theConditions),
    onCells(extension.zeroField(conditions)),
    matrix(extension.laplacian(onCells)),
    solver(matrix.solver(controls(0)))
{}


Foam::harmonicExtension::harmonicExtension
(
    const fvMesh& mesh,
    const pointField& points,
    Istream& diffusivity
)
{
    makeMesh(mesh, points);
    setDiffusivity(diffusivity);
    isCorrected_ =
        gMax(mag(mesh_->nonOrthCorrectionVectors().primitiveField())())
      > tolerance;
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
    laplaceEquation& equation = this->equation(conditions);
    setBoundary(equation, onPoints);
    solve(equation);
    const volScalarField& onCells = equation.onCells;

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
