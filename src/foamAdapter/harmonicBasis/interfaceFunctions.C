/*---------------------------------------------------------------------------*\
    Tokay: OpenFOAM coupled to an isogeometric structure
-------------------------------------------------------------------------------
License
    This file is part of Tokay, which is free software: you can redistribute
    it and/or modify it under the terms of the GNU General Public License as
    published by the Free Software Foundation, either version 3 of the
    License, or (at your option) any later version. See the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "interfaceFunctions.H"
#include "boundBox.H"
#include "ListListOps.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Places nearer than this share of the boundary's extent are the same: the two
//  planes of a 2D mesh, points that ranks share
constexpr scalar samePlace = 1e-9;

//- A direction in which the control points extend less than this share of their
//  largest extent carries no linear function
constexpr scalar flat = 1e-3;

//- Orthogonal directions in which points extend from their centre, of length 1
//  over the extent
static List<vector> extents(vectorField fromCentre, const scalar extent)
{
    DynamicList<vector> found;
    while (found.size() < vector::nComponents)
    {
        const label farthest = findMax(magSqr(fromCentre)());
        const scalar length = mag(fromCentre[farthest]);
        if (length <= flat*extent)
        {
            break;
        }
        const vector unit(fromCentre[farthest]/length);
        fromCentre -= unit*(unit & fromCentre);
        found.append(unit/extent);
    }
    return List<vector>(found);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::interfaceFunctions::chooseControls(const label n)
{
    const boundBox box(allPoints_, false);
    scalarField distance(magSqr(allPoints_ - box.midpoint()));
    const scalar limit = sqr(samePlace)*magSqr(box.span());

    DynamicList<label> controls(n);
    while (controls.size() < n)
    {
        const label next = findMax(distance);
        if (controls.size() > 0 && distance[next] <= limit)
        {
            break;
        }
        const scalarField toNext(magSqr(allPoints_ - allPoints_[next]));
        distance =
            controls.empty() ? toNext : scalarField(min(distance, toNext));
        controls.append(next);
    }
    controls_.transfer(controls);
    controlPoints_ = pointField(allPoints_, controls_);
    centre_ = average(controlPoints_);
    extent_ = mag(box.span()) + VSMALL;
    directions_ = extents(controlPoints_ - centre_, extent_);
}


Foam::scalarField Foam::interfaceFunctions::terms(const point& x) const
{
    const label n = size();
    scalarField term(n + 1 + directions_.size());
    for (label i = 0; i < n; ++i)
    {
        term[i] = pow3(mag(x - controlPoints_[i])/extent_);
    }
    term[n] = 1;
    forAll(directions_, i)
    {
        term[n + 1 + i] = directions_[i] & (x - centre_);
    }
    return term;
}


Foam::List<Foam::scalarField> Foam::interfaceFunctions::weights() const
{
    const label n = size();
    const label nTerms = n + 1 + directions_.size();
    scalarSquareMatrix system(nTerms, Zero);
    for (label i = 0; i < n; ++i)
    {
        const scalarField term(terms(controlPoints_[i]));
        for (label j = 0; j < nTerms; ++j)
        {
            system(i, j) = term[j];
            system(j, i) = term[j];
        }
    }
    labelList pivots(nTerms);
    LUDecompose(system, pivots);

    List<scalarField> weights(n, scalarField(nTerms, Zero));
    for (label function = 0; function < n; ++function)
    {
        weights[function][function] = 1;
        LUBacksubstitute(system, pivots, weights[function]);
    }
    return weights;
}


void Foam::interfaceFunctions::setValues()
{
    const List<scalarField> weight(weights());
    values_ = List<scalarField>(size(), scalarField(points_.size()));
    forAll(points_, i)
    {
        const scalarField term(terms(points_[i]));
        forAll(values_, function)
        {
            values_[function][i] = sumProd(weight[function], term);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceFunctions::interfaceFunctions
(
    const pointField& points,
    const label n
)
:
    points_(points)
{
    List<pointField> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = points;
    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);

    offset_ = 0;
    for (label rank = 0; rank < Pstream::myProcNo(); ++rank)
    {
        offset_ += ofRanks[rank].size();
    }
    allPoints_ =
        ListListOps::combine<pointField>(ofRanks, accessOp<pointField>());

    chooseControls(n);
    setValues();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::interfaceFunctions::isComplete() const
{
    const scalar limit = samePlace*mag(boundBox(allPoints_, false).span());
    for (const point& x : allPoints_)
    {
        if (min(mag(controlPoints_ - x)) > limit)
        {
            return false;
        }
    }
    return true;
}


Foam::vectorField Foam::interfaceFunctions::coefficients
(
    const vectorField& values
) const
{
    vectorField coefficients(size(), Zero);
    forAll(controls_, i)
    {
        const label local = controls_[i] - offset_;
        if (local >= 0 && local < values.size())
        {
            coefficients[i] = values[local];
        }
    }
    reduce(coefficients, sumOp<vectorField>());
    return coefficients;
}


Foam::scalar Foam::interfaceFunctions::residual
(
    const vectorField& values,
    const vectorField& coefficients
) const
{
    vectorField rest(values);
    forAll(values_, function)
    {
        forAll(rest, i)
        {
            rest[i] -= values_[function][i]*coefficients[function];
        }
    }
    return gMax(mag(rest)());
}


// ************************************************************************* //
