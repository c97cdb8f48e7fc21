// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledMotionSolverFvMesh.H"
#include "addToRunTimeSelectionTable.H"
#include "motionSolver.H"
#include "pointFields.H"
#include "structureDisplacementPointPatchVectorField.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(coupledMotionSolverFvMesh, 0);

    addToRunTimeSelectionTable
    (
        dynamicFvMesh,
        coupledMotionSolverFvMesh,
        IOobject
    );
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::coupledMotionSolverFvMesh::coupledDisplacement() const
{
    typedef structureDisplacementPointPatchVectorField coupledPatch;

    DynamicList<point> values;
    if (!foundObject<pointVectorField>("pointDisplacement"))
    {
        return pointField();
    }
    const auto& patches =
        lookupObject<pointVectorField>("pointDisplacement").boundaryField();
    forAll(patches, patchi)
    {
        if (isA<coupledPatch>(patches[patchi]))
        {
            values.append(refCast<const coupledPatch>(patches[patchi]));
        }
    }
    return pointField(values);
}


bool Foam::coupledMotionSolverFvMesh::isThere(const pointField& coupled) const
{
    const bool isSame =
        movedTimeIndex_ == time().timeIndex() && coupled == coupled_;

    return
        returnReduce(isSame, andOp<bool>())
     && returnReduce(!coupled.empty(), orOp<bool>());
}


void Foam::coupledMotionSolverFvMesh::endConditions()
{
    auto& patches =
        lookupObjectRef<pointVectorField>("pointDisplacement")
       .boundaryFieldRef(false);
    forAll(patches, patchi)
    {
        // Not the patch's own, which would set points that a corner has moved
        patches[patchi].pointPatchVectorField::evaluate();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledMotionSolverFvMesh::coupledMotionSolverFvMesh(const IOobject& io)
:
    dynamicMotionSolverFvMesh(io),
    movedTimeIndex_(-1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupledMotionSolverFvMesh::update()
{
    motionSolver& solver = const_cast<motionSolver&>(motion());
    // Here pointDisplacement takes the structure's displacement
    solver.solve();
    pointField coupled(coupledDisplacement());
    if (isThere(coupled))
    {
        endConditions();
        return false;
    }
    fvMesh::movePoints(solver.curPoints()());
    coupled_.transfer(coupled);
    movedTimeIndex_ = time().timeIndex();
    if (foundObject<volVectorField>("U"))
    {
        lookupObjectRef<volVectorField>("U").correctBoundaryConditions();
    }
    return true;
}


// ************************************************************************* //
