// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonicBasis.H"
#include "bitSet.H"
#include "twoDPointCorrector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Points that take a smaller fraction of a translation of the boundary do not
//  turn with it (they would by less than the fourth power of this)
constexpr scalar minFraction = 0.01;

//- Rows of W that are multiplied by all functions before the next ones: as many
//  as the processor's first cache has room for, with their products
constexpr label rowsInCache = 256;

//- Change of a vector by a rotation (Rodrigues)
//  \param angle  along the axis, of the angle's length [rad]
static vector turned(const vector& v, const vector& angle)
{
    const scalar size = mag(angle);
    if (size < SMALL)
    {
        return angle ^ v;
    }
    const vector axis(angle/size);
    const vector across(axis ^ v);
    return sin(size)*across + (1 - cos(size))*(axis ^ across);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::harmonicBasis::pairPoints()
{
    const fvMesh& mesh = boundary_.mesh();
    bitSet hasRow(mesh.nPoints(), true);
    if (mesh.nGeometricD() == 2)
    {
        const edgeList& edges = mesh.edges();
        DynamicList<label> plane, partners;
        for
        (
            const label edgei
          : twoDPointCorrector::New(mesh).normalEdgeIndices()
        )
        {
            plane.append(max(edges[edgei][0], edges[edgei][1]));
            partners.append(min(edges[edgei][0], edges[edgei][1]));
        }
        planePoints_.transfer(plane);
        partners_.transfer(partners);
        hasRow.unset(planePoints_);
    }
    rows_ = hasRow.sortedToc();
}


void Foam::harmonicBasis::extend
(
    const harmonicExtension& extension,
    harmonicBasis* known
)
{
    W_ = List<List<scalarField>>(sets_.size(), List<scalarField>(size()));
    const label nPoints = boundary_.mesh().nPoints();
    forAll(sets_, set)
    {
        const auto conditions(constraints_.conditions(sets_[set].odd));
        for
        (
            label first = known ? known->size() : 0;
            first < size();
            first += blockSize
        )
        {
            List<scalarField> onPoints
            (
                min(blockSize, size() - first),
                scalarField(nPoints, Zero)
            );
            forAll(onPoints, i)
            {
                UIndirectList<scalar>(onPoints[i], boundary_.points()) =
                    functions_.values(first + i);
            }
            onPoints = extension.extend(onPoints, conditions);
            forAll(onPoints, i)
            {
                W_[set][first + i] = scalarField(onPoints[i], rows_);
            }
        }
        if (known)
        {
            combine(set, *known);
        }
    }
}


void Foam::harmonicBasis::combine(const label set, harmonicBasis& known)
{
    List<scalarField>& W = W_[set];
    List<scalarField> excess(known.size());
    forAll(excess, i)
    {
        // What the known function is at the further control points
        excess[i] = functions_.coefficients(known.functions_.values(i));
        W[i] = atRows(known, known.W_[set][i]);
        known.W_[set][i].clear();
    }
    // Few rows at a time, which stay in the cache
    for (label first = 0; first < rows_.size(); first += rowsInCache)
    {
        const label end = min(first + rowsInCache, rows_.size());
        forAll(excess, i)
        {
            for (label k = known.size(); k < size(); ++k)
            {
                for (label row = first; row < end; ++row)
                {
                    W[i][row] -= excess[i][k]*W[k][row];
                }
            }
        }
    }
}


template<class Type>
Foam::Field<Type> Foam::harmonicBasis::atRows
(
    const harmonicBasis& known,
    const Field<Type>& values
) const
{
    Field<Type> onPoints(boundary_.mesh().nPoints(), Zero);
    UIndirectList<Type>(onPoints, known.rows_) = values;
    return Field<Type>(onPoints, rows_);
}


void Foam::harmonicBasis::addProducts
(
    const label set,
    const label function,
    const label start,
    const label end,
    vectorField& displacement,
    vectorField& angle
) const
{
    // Both products at once: reading W takes the time
    const scalarField& values = W_[set][function];
    const vector coefficient
    (
        cmptMultiply(coefficients_[function], sets_[set].ofDisplacement)
    );
    if (!rotation_)
    {
        for (label row = start; row < end; ++row)
        {
            displacement[row] += values[row]*coefficient;
        }
        return;
    }
    const vector rotation
    (
        cmptMultiply(rotations_[function], sets_[set].ofRotation)
    );
    for (label row = start; row < end; ++row)
    {
        displacement[row] += values[row]*coefficient;
        angle[row] += values[row]*rotation;
    }
}


void Foam::harmonicBasis::keepMovingRows()
{
    bitSet moves(rows_.size());
    for (const List<scalarField>& ofSet : W_)
    {
        for (const scalarField& values : ofSet)
        {
            forAll(values, row)
            {
                if (values[row] != 0)
                {
                    moves.set(row);
                }
            }
        }
    }
    const labelList kept(moves.sortedToc());
    rows_ = labelList(UIndirectList<label>(rows_, kept));
    for (List<scalarField>& ofSet : W_)
    {
        for (scalarField& values : ofSet)
        {
            values = scalarField(values, kept);
        }
    }
}


void Foam::harmonicBasis::setFeet
(
    const harmonicExtension& extension,
    const pointField& coordinates,
    scalarField& fractions,
    List<scalarField>& feet
) const
{
    // The fractions come after the axes
    constexpr label nAxes = vector::nComponents;
    List<List<harmonicExtension::condition>> conditions(nAxes + 1);
    DynamicList<label> remaining;
    for (direction axis = 0; axis < nAxes; ++axis)
    {
        if (constraints_.isUsed(axis))
        {
            conditions[axis] = constraints_.conditionsOfCoordinate(axis);
            remaining.append(axis);
        }
    }
    conditions[nAxes] = constraints_.conditions(FixedList<bool, 3>(false));
    remaining.append(nAxes);

    while (!remaining.empty())
    {
        // Those with the same conditions in one block
        DynamicList<label> group, others;
        List<scalarField> fields(1, scalarField(coordinates.size(), 1));
        for (const label i : remaining)
        {
            if (conditions[i] != conditions[remaining[0]])
            {
                others.append(i);
                continue;
            }
            group.append(i);
            if (i < nAxes)
            {
                fields.append(scalarField(coordinates.component(i)));
            }
        }
        fields = extension.extend(fields, conditions[group[0]]);
        const scalarField weights(fields[0], rows_);
        forAll(group, i)
        {
            if (group[i] == nAxes)
            {
                fractions = weights;
            }
            else
            {
                feet[group[i]] = scalarField(fields[i + 1], rows_)/weights;
            }
        }
        remaining.transfer(others);
    }
}


void Foam::harmonicBasis::setOffsets
(
    const harmonicExtension& extension,
    const pointField& points0
)
{
    const pointField coordinates(constraints_.frame() & points0);
    scalarField fractions;
    List<scalarField> feet(vector::nComponents);
    setFeet(extension, coordinates, fractions, feet);
    fades_ = pow3(fractions);
    offsets_ = vectorField(rows_.size(), Zero);
    for (direction axis = 0; axis < vector::nComponents; ++axis)
    {
        if (!constraints_.isUsed(axis))
        {
            continue;
        }
        const bitSet isGiven(constraints_.coordinateIsGiven(axis));
        forAll(rows_, row)
        {
            if (fractions[row] > minFraction && !isGiven[rows_[row]])
            {
                offsets_[row][axis] =
                    coordinates[rows_[row]][axis] - feet[axis][row];
            }
        }
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::harmonicBasis::memory
(
    const movingBoundary& boundary,
    const motionConstraints& constraints,
    const label n,
    const bool rotation
)
{
    const fvMesh& mesh = boundary.mesh();
    const scalar nRows = mesh.nPoints()/(mesh.nGeometricD() == 2 ? 2 : 1);
    const scalar nNumbers =
        constraints.sets(rotation).size()*n*nRows
      + interfaceFunctions::nNumbers(boundary.points().size(), n, rotation);
    return returnReduce(sizeof(scalar)*nNumbers, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::harmonicBasis::harmonicBasis
(
    const movingBoundary& boundary,
    const motionConstraints& constraints,
    const pointField& points0,
    const label n,
    Istream& diffusivity,
    const bool rotation,
    harmonicBasis* known
)
:
    boundary_(boundary),
    constraints_(constraints),
    functions_
    (
        boundary.places(points0),
        boundary.areas(points0),
        n,
        rotation
    ),
    rotation_(rotation),
    sets_(constraints.sets(rotation))
{
    const harmonicExtension extension(boundary.mesh(), points0, diffusivity);
    cellHeight_ = extension.firstCellHeight(boundary.patches());
    pairPoints();
    if (known && !known->functions_.areWithin(functions_))
    {
        known = nullptr;
    }
    extend(extension, known);
    keepMovingRows();
    if (rotation_ && known)
    {
        offsets_ = atRows(*known, known->offsets_);
        fades_ = atRows(*known, known->fades_);
    }
    else if (rotation_)
    {
        setOffsets(extension, points0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::harmonicBasis::writeSize(Ostream& os) const
{
    const label nBoundary = boundary_.points().size();
    const scalar nNumbers =
        scalar(size())*(sets_.size()*rows_.size() + nBoundary)
      + (rotation_ ? 2*sqr(scalar(size())) : 0);
    os  << size() << " functions for "
        << returnReduce(nBoundary, sumOp<label>()) << " boundary points, "
        << returnReduce(rows_.size(), sumOp<label>()) << " of "
        << returnReduce(boundary_.mesh().nPoints(), sumOp<label>())
        << " points move, ";
    if (sets_.size() > 1)
    {
        os  << "extended in " << sets_.size()
            << " ways for planes in which the mesh slides, ";
    }
    os  << returnReduce(sizeof(scalar)*nNumbers, maxOp<scalar>())/1e6
        << " MB on a rank";
}


Foam::scalar Foam::harmonicBasis::fit()
{
    const vectorField displacement(boundary_.displacement());
    const vectorField atControls(functions_.coefficients(displacement));
    coefficients_ = constraints_.frame() & atControls;
    if (rotation_)
    {
        rotations_ = constraints_.frame() & functions_.rotations(atControls);
    }
    return functions_.residual(displacement, atControls);
}


void Foam::harmonicBasis::apply(vectorField& onPoints) const
{
    vectorField displacement(rows_.size(), Zero);
    vectorField angle(rotation_ ? rows_.size() : 0, Zero);
    for (label start = 0; start < rows_.size(); start += rowsInCache)
    {
        const label end = min(start + rowsInCache, rows_.size());
        forAll(sets_, set)
        {
            forAll(W_[set], function)
            {
                addProducts(set, function, start, end, displacement, angle);
            }
        }
    }
    forAll(angle, row)
    {
        displacement[row] += turned(offsets_[row], fades_[row]*angle[row]);
    }

    onPoints = Zero;
    UIndirectList<vector>(onPoints, rows_) =
        (constraints_.frame().T() & displacement)();
    forAll(planePoints_, i)
    {
        onPoints[planePoints_[i]] = onPoints[partners_[i]];
    }
}


// ************************************************************************* //
