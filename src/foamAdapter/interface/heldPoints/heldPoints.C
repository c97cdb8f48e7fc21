// SPDX-License-Identifier: GPL-3.0-or-later
#include "heldPoints.H"
#include "boundBox.H"
#include "emptyPolyPatch.H"
#include "openfoamVersion.H"
#include "points0MotionSolver.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Fractions of the interface's largest displacement by which a point may be
//  off: without a warning, and before the run ends
constexpr Foam::scalar warnedFraction = 0.01;
constexpr Foam::scalar refusedFraction = 0.5;

//- Rounding of files and of weak supports, as a fraction of the extent
constexpr Foam::scalar roundingFraction = 1e-6;

//- Digits of displacements in messages
constexpr int digits = 4;

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::heldPoints::holders(const label meshPoint) const
{
    OStringStream os;
    forAll(mesh_.boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        if
        (
            !patch.coupled()
         && !isA<emptyPolyPatch>(patch)
         && !patches_.found(patchi)
         && patch.meshPointMap().found(meshPoint)
        )
        {
            os  << (os.str().empty() ? "" : ", ") << '\'' << patch.name()
                << "' ("
                << pointDisplacement_.boundaryField()[patchi].type() << ')';
        }
    }
    return os.str();
}


Foam::heldPoints::findings Foam::heldPoints::find
(
    const List<vectorField>& displacement,
    const scalar limit
) const
{
    findings found{0, 0, string()};
    forAll(patches_, i)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patches_[i]];
        forAll(patch.meshPoints(), pointi)
        {
            const label meshPoint = patch.meshPoints()[pointi];
            const vector moved
            (
                mesh_.points()[meshPoint] - points0_[i][pointi]
            );
            const scalar off = mag(moved - displacement[i][pointi]);
            if (off <= limit)
            {
                continue;
            }
            ++found.count;
            if (off > found.largest)
            {
                OStringStream os;
                os.precision(digits);
                os  << points0_[i][pointi] << " of patch '" << patch.name()
                    << "' moves by " << moved << " m where the structure moves "
                    << "by " << displacement[i][pointi]
                    << " m; it belongs to " << holders(meshPoint).c_str()
                    << " too";
                found.largest = off;
                found.where = os.str();
            }
        }
    }
    return found;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heldPoints::heldPoints
(
    const fvMesh& mesh,
    const pointVectorField& pointDisplacement,
    const labelList& patches
)
:
    mesh_(mesh),
    pointDisplacement_(pointDisplacement),
    patches_(patches),
    points0_(patches.size()),
    nPoints_(0),
    rounding_(0),
    isWarned_(false)
{
    const pointIOField points0(points0MotionSolver::points0IO(mesh));
    boundBox extent;
    forAll(patches_, i)
    {
        points0_[i] = pointField
        (
            points0,
            mesh.boundaryMesh()[patches_[i]].meshPoints()
        );
        extent.add(points0_[i]);
        nPoints_ += points0_[i].size();
    }
    extent.reduce();
    reduce(nPoints_, sumOp<label>());
    rounding_ = roundingFraction*extent.mag();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::heldPoints::check(const List<vectorField>& displacement)
{
    scalar scale = 0;
    for (const vectorField& ofPatch : displacement)
    {
        for (const vector& d : ofPatch)
        {
            scale = max(scale, mag(d));
        }
    }
    reduce(scale, maxOp<scalar>());

    findings own(find(displacement, max(warnedFraction*scale, rounding_)));
    const scalar largest = returnReduce(own.largest, maxOp<scalar>());
    if (largest == 0)
    {
        return string();
    }
    List<string> texts(Pstream::nProcs());
    texts[Pstream::myProcNo()] = own.largest == largest ? own.where : string();
    shareAmongRanks(texts);
    reduce(own.count, sumOp<label>());

    OStringStream os;
    os.precision(digits);
    os  << own.count << " of " << nPoints_ << " points of the coupled patches "
        << "do not follow the structure, by up to " << 100*largest/scale
        << " % of its largest displacement: ";
    for (const string& text : texts)
    {
        if (!text.empty())
        {
            os  << text.c_str();
            break;
        }
    }
    os  << ". Support the structure there, couple that patch as well, or let "
        << "its pointDisplacement follow, by a condition that leaves the "
        << "points free in this direction";
    if (largest > refusedFraction*scale)
    {
        return os.str();
    }
    if (!isWarned_)
    {
        isWarned_ = true;
        WarningInFunction << os.str().c_str() << endl;
    }
    return string();
}


// ************************************************************************* //
