// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonicBasis.H"
#include "harmonicExtension.H"
#include "bitSet.H"
#include "twoDPointCorrector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Points that take less of a translation of the boundary do not turn with it
//  (they would by less than the fourth power of this)
constexpr scalar leastShare = 0.01;

//- What a rotation changes of a vector (Rodrigues)
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
    const pointField& points0,
    Istream& diffusivity
)
{
    const harmonicExtension extension
    (
        boundary_.mesh(),
        points0,
        boundary_.pointDisplacement(),
        boundary_.patches(),
        diffusivity
    );
    cellHeight_ = extension.firstCellHeight();
    W_.setSize(functions_.size());
    scalarField onPoints(boundary_.mesh().nPoints(), Zero);
    forAll(W_, function)
    {
        UIndirectList<scalar>(onPoints, boundary_.points()) =
            functions_.values(function);
        W_[function] = scalarField(extension.extend(onPoints), rows_);
    }
}


void Foam::harmonicBasis::keepMovingRows()
{
    bitSet moves(rows_.size());
    for (const scalarField& values : W_)
    {
        forAll(values, row)
        {
            if (values[row] != 0)
            {
                moves.set(row);
            }
        }
    }
    const labelList kept(moves.sortedToc());
    rows_ = labelList(UIndirectList<label>(rows_, kept));
    for (scalarField& values : W_)
    {
        values = scalarField(values, kept);
    }
}


Foam::vectorField Foam::harmonicBasis::product
(
    const vectorField& ofFunctions
) const
{
    vectorField sums(rows_.size(), Zero);
    forAll(W_, function)
    {
        const scalarField& values = W_[function];
        const vector& factor = ofFunctions[function];
        forAll(values, row)
        {
            sums[row] += values[row]*factor;
        }
    }
    return sums;
}


void Foam::harmonicBasis::setOffsets(const pointField& points0)
{
    const vectorField ones(size(), vector::uniform(1));
    const scalarField shares(product(ones).component(vector::X));
    const vectorField feet(product(functions_.controlPoints()));
    offsets_ = boundary_.inPlane(vectorField(points0, rows_));
    forAll(offsets_, row)
    {
        if (shares[row] > leastShare)
        {
            offsets_[row] -= feet[row]/shares[row];
        }
        else
        {
            offsets_[row] = Zero;
        }
    }
    fades_ = pow3(shares);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::harmonicBasis::memory
(
    const movingBoundary& boundary,
    const label n
)
{
    const fvMesh& mesh = boundary.mesh();
    const scalar rows = mesh.nPoints()/(mesh.nGeometricD() == 2 ? 2 : 1);
    const scalar values = rows + boundary.points().size() + 2*scalar(n);
    return returnReduce(sizeof(scalar)*n*values, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::harmonicBasis::harmonicBasis
(
    const movingBoundary& boundary,
    const pointField& points0,
    const label n,
    Istream& diffusivity,
    const bool rotation
)
:
    boundary_(boundary),
    functions_(boundary.places(points0), boundary.areas(points0), n),
    rotation_(rotation)
{
    pairPoints();
    extend(points0, diffusivity);
    keepMovingRows();
    if (rotation_)
    {
        setOffsets(points0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::harmonicBasis::writeSize(Ostream& os) const
{
    const label nBoundary = boundary_.points().size();
    const scalar values = scalar(size())*(rows_.size() + nBoundary);
    os  << size() << " functions for "
        << returnReduce(nBoundary, sumOp<label>()) << " boundary points, "
        << returnReduce(rows_.size(), sumOp<label>()) << " of "
        << returnReduce(boundary_.mesh().nPoints(), sumOp<label>())
        << " points move, "
        << returnReduce(sizeof(scalar)*values, maxOp<scalar>())/1e6
        << " MB on a rank";
}


Foam::scalar Foam::harmonicBasis::fit()
{
    const vectorField displacement(boundary_.displacement());
    coefficients_ = functions_.coefficients(displacement);
    if (rotation_)
    {
        rotations_ = functions_.rotations(coefficients_);
    }
    return functions_.residual(displacement, coefficients_);
}


void Foam::harmonicBasis::apply(vectorField& onPoints) const
{
    vectorField displacement(rows_.size(), Zero);
    if (rotation_)
    {
        // Both products at once: reading W takes the time
        vectorField angle(rows_.size(), Zero);
        forAll(W_, function)
        {
            const scalarField& values = W_[function];
            const vector& coefficient = coefficients_[function];
            const vector& rotation = rotations_[function];
            forAll(values, row)
            {
                displacement[row] += values[row]*coefficient;
                angle[row] += values[row]*rotation;
            }
        }
        forAll(displacement, row)
        {
            displacement[row] += turned(offsets_[row], fades_[row]*angle[row]);
        }
    }
    else
    {
        displacement = product(coefficients_);
    }

    onPoints = Zero;
    UIndirectList<vector>(onPoints, rows_) = displacement;
    forAll(planePoints_, i)
    {
        onPoints[planePoints_[i]] = onPoints[partners_[i]];
    }
}


// ************************************************************************* //
