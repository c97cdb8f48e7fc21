// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacianMotion.H"
#include "limitedDiffusivity.H"
#include "fvmLaplacian.H"
#include "fvMatrix.H"
#include "StringStream.H"
#include "volPointInterpolation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Normalised residual below which sweeps change nothing
constexpr scalar nothingToSweep = 1e-14;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::laplacianMotion::takePresentMotion()
{
    const labelListList& cellPoints = fvMesh_.cellPoints();
    vectorField& onCells = cellDisplacement_.primitiveFieldRef();
    forAll(onCells, celli)
    {
        onCells[celli] = average
        (
            vectorField(pointDisplacement_.primitiveField(), cellPoints[celli])
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::laplacianMotion::laplacianMotion
(
    pointVectorField& pointDisplacement,
    const string& diffusivity,
    const label sweeps
)
:
    fvMotionSolver(pointDisplacement.mesh()()),
    pointDisplacement_(pointDisplacement),
    cellDisplacement_
    (
        IOobject
        (
            "cellDisplacement",
            fvMesh_.time().timeName(),
            fvMesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        fvMesh_,
        dimensionedVector(pointDisplacement.dimensions(), Zero),
        cellMotionBoundaryTypes<vector>(pointDisplacement.boundaryField())
    ),
    diffusivityEntry_(diffusivity)
{
    solver_.add("solver", word("PCG"));
    solver_.add("preconditioner", word("DIC"));
    solver_.add("tolerance", nothingToSweep);
    solver_.add("relTol", 0);
    solver_.add("maxIter", sweeps);
    if (!cellDisplacement_.typeHeaderOk<volVectorField>(true))
    {
        takePresentMotion();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::laplacianMotion::solve()
{
    if (!diffusivity_.valid())
    {
        IStringStream entry(diffusivityEntry_);
        diffusivity_ = motionDiffusivity::New(fvMesh_, entry);
    }
    fvVectorMatrix equation
    (
        fvm::laplacian
        (
            limitedDiffusivity(*diffusivity_)(),
            cellDisplacement_,
            "laplacian(diffusivity,cellDisplacement)"
        )
    );
    equation.solve(solver_);
}


void Foam::laplacianMotion::apply() const
{
    volPointInterpolation::New(fvMesh_).interpolate
    (
        cellDisplacement_,
        pointDisplacement_
    );
}


void Foam::laplacianMotion::updateMesh()
{
    diffusivity_.clear();
}


// ************************************************************************* //
