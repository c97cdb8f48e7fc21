/*---------------------------------------------------------------------------*\
    Tokay: OpenFOAM coupled to an isogeometric structure
-------------------------------------------------------------------------------
License
    This file is part of Tokay, which is free software: you can redistribute
    it and/or modify it under the terms of the GNU General Public License as
    published by the Free Software Foundation, either version 3 of the
    License, or (at your option) any later version. See the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "harmonicBasisMotionSolver.H"
#include "structureDisplacementPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "bitSet.H"
#include "clockTime.H"
#include "fixedValuePointPatchFields.H"
#include "pointConstraints.H"
#include "requireKnownEntries.H"
#include "StringStream.H"
#include "twoDPointCorrector.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(harmonicBasisMotionSolver, 0);

    addToRunTimeSelectionTable
    (
        motionSolver,
        harmonicBasisMotionSolver,
        dictionary
    );

    addToRunTimeSelectionTable
    (
        displacementMotionSolver,
        harmonicBasisMotionSolver,
        displacement
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::harmonicBasisMotionSolver::selectPatches() const
{
    requireKnownEntries
    (
        coeffDict(),
        {"patches", "nFunctions", "diffusivity", "fitLimit", "memoryLimit"}
    );
    const polyBoundaryMesh& patches = fvMesh_.boundaryMesh();
    if (coeffDict().found("patches"))
    {
        const wordRes names(coeffDict().get<wordRes>("patches"));
        const labelList selected(patches.patchSet(names).sortedToc());
        if (selected.empty())
        {
            FatalIOErrorInFunction(coeffDict())
                << "no patch matches 'patches' " << names << nl
                << "    the mesh has " << patches.names()
                << exit(FatalIOError);
        }
        return selected;
    }

    DynamicList<label> selected;
    forAll(patches, patchi)
    {
        if
        (
            isA<structureDisplacementPointPatchVectorField>
            (
                pointDisplacement_.boundaryField()[patchi]
            )
        )
        {
            selected.append(patchi);
        }
    }
    if (selected.empty())
    {
        FatalIOErrorInFunction(coeffDict())
            << "no patch of pointDisplacement has the condition '"
            << structureDisplacementPointPatchVectorField::typeName << "'"
            << nl << "    name the patches that move in an entry 'patches'"
            << exit(FatalIOError);
    }
    return selected;
}


Foam::labelList Foam::harmonicBasisMotionSolver::selectBoundaryPoints() const
{
    labelHashSet points;
    for (const label patchi : patches_)
    {
        points.insert(fvMesh_.boundaryMesh()[patchi].meshPoints());
    }
    return points.sortedToc();
}


Foam::pointField Foam::harmonicBasisMotionSolver::boundaryPlaces() const
{
    pointField places(points0(), boundaryPoints_);
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (fvMesh_.geometricD()[cmpt] < 0)
        {
            places.replace(cmpt, 0);
        }
    }
    return places;
}


void Foam::harmonicBasisMotionSolver::pairPoints()
{
    planePoints_.clear();
    partners_.clear();
    if (fvMesh_.nGeometricD() != 2)
    {
        return;
    }
    const edgeList& edges = fvMesh_.edges();
    DynamicList<label> plane, partners;
    for
    (
        const label edgei
      : twoDPointCorrector::New(fvMesh_).normalEdgeIndices()
    )
    {
        plane.append(max(edges[edgei][0], edges[edgei][1]));
        partners.append(min(edges[edgei][0], edges[edgei][1]));
    }
    planePoints_.transfer(plane);
    partners_.transfer(partners);
}


Foam::string Foam::harmonicBasisMotionSolver::diffusivity() const
{
    OStringStream type;
    if (coeffDict().found("diffusivity"))
    {
        for (const token& part : coeffDict().lookup("diffusivity"))
        {
            type << part << ' ';
        }
    }
    else
    {
        wordList names(patches_.size());
        forAll(names, i)
        {
            names[i] = fvMesh_.boundaryMesh()[patches_[i]].name();
        }
        type << "quadratic inverseDistance " << names;
    }
    return type.str();
}


void Foam::harmonicBasisMotionSolver::checkMemory() const
{
    const scalar bytes = 8.0*functions_->size()*fvMesh_.nPoints()
       /(planePoints_.empty() ? 1 : 2);
    if (returnReduce(bytes, maxOp<scalar>()) > memoryLimit_)
    {
        FatalIOErrorInFunction(coeffDict())
            << "the motion needs " << functions_->size()
            << " functions, which can take more than the 'memoryLimit' of "
            << memoryLimit_/1e6 << " MB on a rank" << nl
            << "    raise it, use more ranks or fewer functions with a larger "
            << "'fitLimit', or choose the solver displacementLaplacian"
            << exit(FatalIOError);
    }
}


void Foam::harmonicBasisMotionSolver::build()
{
    const clockTime clock;
    pairPoints();
    functions_.reset(new interfaceFunctions(boundaryPlaces(), nFunctions_));
    nFunctions_ = functions_->size();
    state_.set("nFunctions", nFunctions_);
    checkMemory();

    IStringStream diffusivityStream(diffusivity());
    const harmonicExtension extension
    (
        fvMesh_,
        points0(),
        pointDisplacement_,
        patches_,
        diffusivityStream
    );
    cellHeight_ = extension.firstCellHeight();
    W_.setSize(nFunctions_);
    scalarField onPoints(fvMesh_.nPoints(), Zero);
    forAll(W_, function)
    {
        UIndirectList<scalar>(onPoints, boundaryPoints_) =
            functions_->values(function);
        W_[function] = extension.extend(onPoints);
    }
    keepMovingRows();

    Info<< typeName << ": " << nFunctions_ << " functions for "
        << returnReduce(boundaryPoints_.size(), sumOp<label>())
        << " boundary points, "
        << returnReduce(movingPoints_.size(), sumOp<label>()) << " of "
        << returnReduce(fvMesh_.nPoints(), sumOp<label>())
        << " points move, built in " << clock.elapsedTime() << " s" << nl
        << endl;
}


void Foam::harmonicBasisMotionSolver::keepMovingRows()
{
    bitSet moves(fvMesh_.nPoints());
    for (const scalarField& values : W_)
    {
        forAll(values, pointi)
        {
            if (values[pointi] != 0)
            {
                moves.set(pointi);
            }
        }
    }
    // A pair moves as one
    moves.unset(planePoints_);
    movingPoints_ = moves.sortedToc();
    for (scalarField& values : W_)
    {
        values = scalarField(values, movingPoints_);
    }
}


Foam::vectorField
Foam::harmonicBasisMotionSolver::boundaryDisplacement() const
{
    vectorField onPoints(fvMesh_.nPoints(), Zero);
    for (const label patchi : patches_)
    {
        const auto& values = refCast<const fixedValuePointPatchVectorField>
        (
            pointDisplacement_.boundaryField()[patchi]
        );
        UIndirectList<vector>
        (
            onPoints,
            fvMesh_.boundaryMesh()[patchi].meshPoints()
        ) = values;
    }
    return vectorField(onPoints, boundaryPoints_);
}


Foam::scalar Foam::harmonicBasisMotionSolver::otherMotion() const
{
    scalar largest = 0;
    forAll(pointDisplacement_.boundaryField(), patchi)
    {
        const auto* values = isA<fixedValuePointPatchVectorField>
        (
            pointDisplacement_.boundaryField()[patchi]
        );
        if (values && values->size() > 0 && !patches_.found(patchi))
        {
            largest = max(largest, max(mag(*values)));
        }
    }
    return largest;
}


bool Foam::harmonicBasisMotionSolver::fit(const vectorField& displacement)
{
    coefficients_ = functions_->coefficients(displacement);
    const vector2D misses
    (
        returnReduce
        (
            vector2D
            (
                functions_->residual(displacement, coefficients_),
                otherMotion()
            ),
            maxOp<vector2D>()
        )
    );
    if (misses[1] > 0)
    {
        FatalErrorInFunction
            << "a patch that is not among 'patches' moves, by " << misses[1]
            << " m" << nl
            << "    name all patches that move in 'patches' of "
            << typeName << "Coeffs in constant/dynamicMeshDict"
            << exit(FatalError);
    }
    return misses[0] <= fitLimit_*cellHeight_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::harmonicBasisMotionSolver::harmonicBasisMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict
)
:
    displacementMotionSolver(mesh, dict, typeName)
{}


Foam::harmonicBasisMotionSolver::harmonicBasisMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict,
    const pointVectorField& pointDisplacement,
    const pointIOField& points0
)
:
    displacementMotionSolver(mesh, dict, pointDisplacement, points0, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::pointField> Foam::harmonicBasisMotionSolver::curPoints() const
{
    vectorField displacement(movingPoints_.size(), Zero);
    forAll(W_, function)
    {
        const scalarField& values = W_[function];
        const vector& coefficient = coefficients_[function];
        forAll(values, i)
        {
            displacement[i] += values[i]*coefficient;
        }
    }
    vectorField& onPoints = pointDisplacement_.primitiveFieldRef();
    onPoints = Zero;
    UIndirectList<vector>(onPoints, movingPoints_) = displacement;
    forAll(planePoints_, i)
    {
        onPoints[planePoints_[i]] = onPoints[partners_[i]];
    }
    pointConstraints::New(pointDisplacement_.mesh())
        .constrainDisplacement(pointDisplacement_, false);

    tmp<pointField> points(points0() + pointDisplacement_.primitiveField());
    twoDCorrectPoints(points.ref());
    return points;
}


void Foam::harmonicBasisMotionSolver::solve()
{
    pointDisplacement_.boundaryFieldRef().updateCoeffs();
    const vectorField displacement(boundaryDisplacement());
    if (!functions_.valid())
    {
        build();
    }
    while (!fit(displacement) && !functions_->isComplete())
    {
        nFunctions_ *= 2;
        build();
    }
}


void Foam::harmonicBasisMotionSolver::updateMesh(const mapPolyMesh& map)
{
    displacementMotionSolver::updateMesh(map);
    boundaryPoints_ = selectBoundaryPoints();
    functions_.clear();
}


// ************************************************************************* //
