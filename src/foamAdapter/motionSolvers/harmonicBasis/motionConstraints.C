// SPDX-License-Identifier: GPL-3.0-or-later
#include "motionConstraints.H"
#include "calculatedPointPatchFields.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "fixedNormalSlipPointPatchFields.H"
#include "fixedValuePointPatchFields.H"
#include "processorCyclicPolyPatch.H"
#include "slipPointPatchFields.H"
#include "StringStream.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "syncTools.H"
#include "zeroGradientPointPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Directions that differ by a smaller angle are the same [rad]
constexpr scalar sameDirection = 1e-4;

//- A coordinate axis that lies this close to the axes that there are cannot
//  complete them
constexpr scalar leastRemainder = 0.1;

//- The entry 'n' of a condition fixedNormalSlip, which has no access to it
static vector slipNormal(const pointPatchVectorField& condition)
{
    OStringStream entries;
    condition.write(entries);
    IStringStream text(entries.str());
    return normalised(dictionary(text).get<vector>("n"));
}

//- Whether two directions are parallel, whatever their signs
static bool isParallel(const vector& a, const vector& b)
{
    return mag(a ^ b) <= sameDirection;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::motionConstraints::patchArea Foam::motionConstraints::areaOf
(
    const label patchi,
    const pointField& points
) const
{
    patchArea area;
    for (const polyPatch& patch : boundary_.mesh().boundaryMesh())
    {
        const auto* part = isA<processorCyclicPolyPatch>(patch);
        if ((part ? part->referPatchID() : patch.index()) == patchi)
        {
            for (const face& f : patch)
            {
                area.normal += f.areaNormal(points);
                area.size += f.mag(points);
                area.moment += f.mag(points)*f.centre(points);
            }
        }
    }
    reduce(area.normal, sumOp<vector>());
    reduce(area.size, sumOp<scalar>());
    reduce(area.moment, sumOp<vector>());
    return area;
}


Foam::vector Foam::motionConstraints::normalOf
(
    const label patchi,
    const pointField& points
)
{
    const polyPatch& patch = boundary_.mesh().boundaryMesh()[patchi];
    const pointPatchVectorField& condition =
        boundary_.pointDisplacement().boundaryField()[patchi];

    const vector normal(normalised(areaOf(patchi, points).normal));
    bool isPlane = true;
    for (const face& f : patch)
    {
        isPlane = isPlane && isParallel(f.unitNormal(points), normal);
    }
    if (isA<fixedNormalSlipPointPatchVectorField>(condition))
    {
        isPlane = isPlane && isParallel(slipNormal(condition), normal);
    }
    if (!returnReduce(isPlane, andOp<bool>()))
    {
        obstacle_ =
            "patch '" + patch.name() + "', on which points slide ("
          + condition.type() + "), is not a plane";
    }
    return normal;
}


Foam::vector Foam::motionConstraints::separationOf
(
    const label patchi,
    const pointField& points
)
{
    const auto& patch = refCast<const cyclicPolyPatch>
    (
        boundary_.mesh().boundaryMesh()[patchi]
    );
    const patchArea own(areaOf(patchi, points));
    const patchArea neighbour(areaOf(patch.neighbPatchID(), points));
    if
    (
        patch.transform() == coupledPolyPatch::ROTATIONAL
     || !returnReduce(patch.parallel(), andOp<bool>())
     || mag(own.normal + neighbour.normal) > sameDirection*own.size
    )
    {
        obstacle_ =
            "patch '" + patch.name() + "' is a cyclic that rotates";
    }
    const vector separation
    (
        neighbour.moment/(neighbour.size + VSMALL)
      - own.moment/(own.size + VSMALL)
    );
    return
        mag(separation) > sameDirection*sqrt(own.size)
      ? separation
      : vector(Zero);
}


Foam::vector Foam::motionConstraints::setCondition
(
    const label patchi,
    const pointField& points
)
{
    using condition = harmonicExtension::condition;

    const polyPatch& patch = boundary_.mesh().boundaryMesh()[patchi];
    const pointPatchVectorField& ofPoints =
        boundary_.pointDisplacement().boundaryField()[patchi];
    condition& chosen = conditions_[patchi];

    if (boundary_.patches().found(patchi))
    {
        chosen = condition::given;
    }
    else if (isA<emptyPolyPatch>(patch))
    {
        chosen = condition::ofPatch;
    }
    else if (isType<cyclicPolyPatch>(patch))
    {
        chosen = condition::ofPatch;
        return separationOf(patchi, points);
    }
    else if
    (
        isA<symmetryPolyPatch>(patch)
     || isA<symmetryPlanePolyPatch>(patch)
     || isA<slipPointPatchVectorField>(ofPoints)
    )
    {
        chosen = condition::zeroGradient;
        return normalOf(patchi, points);
    }
    else if (isA<cyclicAMIPolyPatch>(patch))
    {
        obstacle_ =
            "patch '" + patch.name() + "' is a " + patch.type()
          + ": what moves at one side changes what it touches";
    }
    else if (polyPatch::constraintType(patch.type()))
    {
        obstacle_ =
            "patch '" + patch.name() + "' is a " + patch.type()
          + ", whose motion is no sum of one for each component";
    }
    else if (isA<fixedValuePointPatchVectorField>(ofPoints))
    {
        chosen = condition::zero;
    }
    else if
    (
        isA<zeroGradientPointPatchVectorField>(ofPoints)
     || isA<calculatedPointPatchVectorField>(ofPoints)
    )
    {
        chosen = condition::zeroGradient;
    }
    else
    {
        obstacle_ =
            "pointDisplacement has the condition '" + ofPoints.type()
          + "' on patch '" + patch.name() + "'";
    }
    return Zero;
}


Foam::label Foam::motionConstraints::axisAlong
(
    DynamicList<vector>& axes,
    const vector& along,
    const label patchi
)
{
    vector unit(normalised(along));
    if (mag(unit) < 0.5)
    {
        return -1;
    }
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        // No rounding in the axes of a mesh that has those of the coordinates
        if (mag(unit[cmpt]) < sqr(sameDirection))
        {
            unit[cmpt] = 0;
        }
    }
    unit.normalise();
    forAll(axes, axis)
    {
        if (isParallel(unit, axes[axis]))
        {
            return axis;
        }
        if (mag(unit & axes[axis]) > sameDirection)
        {
            obstacle_ =
                "patch '" + boundary_.mesh().boundaryMesh()[patchi].name()
              + "' is oblique to another in which points slide or that is"
                " cyclic";
            return -1;
        }
    }
    axes.append(unit);
    return axes.size() - 1;
}


void Foam::motionConstraints::setFrame(DynamicList<vector>& axes)
{
    for
    (
        direction cmpt = 0;
        cmpt < vector::nComponents && axes.size() < vector::nComponents;
        ++cmpt
    )
    {
        vector remainder(Zero);
        remainder[cmpt] = 1;
        for (const vector& axis : axes)
        {
            remainder -= axis*(axis & remainder);
        }
        if (mag(remainder) > leastRemainder)
        {
            axes.append(normalised(remainder));
        }
    }

    // Perpendicular to rounding, and right-handed, so that rotations have the
    // components of vectors
    const vector x(axes[0]);
    const vector y(normalised(axes[1] - x*(x & axes[1])));
    frame_ = tensor(x, y, x ^ y);
}


void Foam::motionConstraints::setProcessorPatches()
{
    for (const polyPatch& patch : boundary_.mesh().boundaryMesh())
    {
        if (isA<processorPolyPatch>(patch))
        {
            conditions_[patch.index()] = harmonicExtension::condition::ofPatch;
        }
        if (const auto* part = isA<processorCyclicPolyPatch>(patch))
        {
            periods_[patch.index()] = periods_[part->referPatchID()];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::motionConstraints::motionConstraints
(
    const movingBoundary& boundary,
    const pointField& points
)
:
    boundary_(boundary),
    conditions_
    (
        boundary.mesh().boundaryMesh().size(),
        harmonicExtension::condition::ofPatch
    ),
    planes_(conditions_.size(), -1),
    periods_(conditions_.size(), -1)
{
    const polyBoundaryMesh& patches = boundary.mesh().boundaryMesh();
    DynamicList<vector> axes;

    // Those of processors come after the mesh's, which all ranks share
    const label nPatches = patches.nNonProcessor();
    for (label patchi = 0; patchi < nPatches && obstacle_.empty(); ++patchi)
    {
        const vector along(setCondition(patchi, points));
        const bool isCyclic = isA<cyclicPolyPatch>(patches[patchi]);
        (isCyclic ? periods_ : planes_)[patchi] =
            axisAlong(axes, along, patchi);
    }
    if (obstacle_.empty())
    {
        setFrame(axes);
        setProcessorPatches();
        setPointsInPlanes();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::motionConstraints::isUsed(const direction axis) const
{
    vector along(Zero);
    along[axis] = 1;
    return mag(boundary_.inPlane(vectorField(1, along & frame_))[0]) > 0.5;
}


Foam::List<Foam::motionConstraints::componentSet>
Foam::motionConstraints::sets(const bool rotation) const
{
    DynamicList<componentSet> found;
    const auto add = [&]
    (
        const FixedList<bool, 3>& odd,
        vector componentSet::*member,
        const direction cmpt
    )
    {
        label i = 0;
        while (i < found.size() && found[i].odd != odd)
        {
            ++i;
        }
        if (i == found.size())
        {
            found.append(componentSet{odd, Zero, Zero});
        }
        (found[i].*member)[cmpt] = 1;
    };

    const bool isPlane = boundary_.mesh().nGeometricD() == 2;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        FixedList<bool, 3> odd(false);
        FixedList<bool, 3> oddRotation(false);
        forAll(odd, axis)
        {
            const bool hasPlane = planes_.found(axis);
            odd[axis] = hasPlane && axis == cmpt;
            oddRotation[axis] = hasPlane && axis != cmpt;
        }
        if (isUsed(cmpt))
        {
            add(odd, &componentSet::ofDisplacement, cmpt);
        }
        // In 2D the only rotation is that across the plane
        if (rotation && isUsed(cmpt) != isPlane)
        {
            add(oddRotation, &componentSet::ofRotation, cmpt);
        }
    }
    return List<componentSet>(found);
}


Foam::List<Foam::harmonicExtension::condition>
Foam::motionConstraints::conditions(const FixedList<bool, 3>& odd) const
{
    List<harmonicExtension::condition> chosen(conditions_);
    forAll(chosen, patchi)
    {
        if (planes_[patchi] >= 0 && odd[planes_[patchi]])
        {
            chosen[patchi] = harmonicExtension::condition::zero;
        }
    }
    return chosen;
}


Foam::List<Foam::harmonicExtension::condition>
Foam::motionConstraints::conditionsOfCoordinate(const direction axis) const
{
    List<harmonicExtension::condition> chosen(conditions_);
    forAll(chosen, patchi)
    {
        if (planes_[patchi] == axis || periods_[patchi] == axis)
        {
            chosen[patchi] = harmonicExtension::condition::given;
        }
    }
    return chosen;
}


void Foam::motionConstraints::setPointsInPlanes()
{
    forAll(inPlanes_, axis)
    {
        inPlanes_[axis] = pointsOf(planes_, axis).sortedToc();
    }
}


Foam::bitSet Foam::motionConstraints::pointsOf
(
    const labelUList& axes,
    const direction axis
) const
{
    const fvMesh& mesh = boundary_.mesh();
    bitSet isFound(mesh.nPoints());
    forAll(axes, patchi)
    {
        if (axes[patchi] == axis)
        {
            isFound.set(mesh.boundaryMesh()[patchi].meshPoints());
        }
    }
    syncTools::syncPointList(mesh, isFound, orEqOp<unsigned int>(), 0u);
    return isFound;
}


Foam::bitSet Foam::motionConstraints::coordinateIsGiven
(
    const direction axis
) const
{
    return pointsOf(planes_, axis) | pointsOf(periods_, axis);
}


void Foam::motionConstraints::updateMesh()
{
    if (obstacle_.empty())
    {
        setPointsInPlanes();
    }
}


void Foam::motionConstraints::keepInPlanes(vectorField& displacement) const
{
    forAll(inPlanes_, axis)
    {
        vector along(Zero);
        along[axis] = 1;
        const vector normal(along & frame_);
        for (const label pointi : inPlanes_[axis])
        {
            displacement[pointi] -= normal*(normal & displacement[pointi]);
        }
    }
}


// ************************************************************************* //
