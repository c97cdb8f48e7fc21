/*---------------------------------------------------------------------------*\
    Tokay: OpenFOAM coupled to an isogeometric structure
-------------------------------------------------------------------------------
License
    This file is part of Tokay, which is free software: you can redistribute
    it and/or modify it under the terms of the GNU General Public License as
    published by the Free Software Foundation, either version 3 of the
    License, or (at your option) any later version. See the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "laplacianMotion.H"
#include "limitedDiffusivity.H"
#include "fvmLaplacian.H"
#include "fvMatrix.H"
#include "StringStream.H"
#include "volPointInterpolation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of the normalised residual, beyond which sweeps change nothing
constexpr scalar roundOff = 1e-14;

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
    solver_.add("tolerance", roundOff);
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
