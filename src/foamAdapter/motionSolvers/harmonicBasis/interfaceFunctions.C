// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaceFunctions.H"
#include "boundBox.H"
#include "ListListOps.H"
#include "openfoamVersion.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Points nearer than this fraction of the boundary's extent are the same:
//  those of the two planes of a 2D mesh, and those that ranks share
constexpr scalar samePlace = 1e-9;

//- A direction in which the control points extend less than this fraction of
//  their largest extent carries no linear function
constexpr scalar flat = 1e-3;

//- A field of each rank, on all of them
static List<vectorField> onAllRanks(const vectorField& values)
{
    List<vectorField> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = values;
    shareAmongRanks(ofRanks);
    return ofRanks;
}

//- One rank's values after another's
static vectorField inOne(const List<vectorField>& ofRanks)
{
    return ListListOps::combine<vectorField>(ofRanks, accessOp<vectorField>());
}

//- Where areas at a point add up to less than this fraction of the largest,
//  they face each other
constexpr scalar cancels = 0.1;

//- Two tangents and the normal, as columns
static tensor frame(const vector& normal)
{
    const vector sizes(cmptMag(normal));
    const vector axis
    (
        sizes.x() <= min(sizes.y(), sizes.z()) ? vector(1, 0, 0)
      : sizes.y() <= sizes.z() ? vector(0, 1, 0)
      : vector(0, 0, 1)
    );
    const vector first(normalised(normal ^ axis));
    return tensor(first, normal ^ first, normal).T();
}

//- The rotation of the polar decomposition, by Newton's method (Higham 1986)
static tensor rotationOf(tensor F)
{
    scalar change = GREAT;
    for (label pass = 0; pass < 50 && change > 1e-14; ++pass)
    {
        const tensor next(0.5*(F + inv(F).T()));
        change = mag(next - F);
        F = next;
    }
    return F;
}

//- Along the axis of a rotation, of its angle's length
static vector rotationVector(const tensor& R)
{
    const vector twiceSine(R.zy() - R.yz(), R.xz() - R.zx(), R.yx() - R.xy());
    const scalar sine = 0.5*mag(twiceSine);
    const scalar angle = atan2(sine, 0.5*(tr(R) - 1));
    return sine > SMALL ? vector(twiceSine*(0.5*angle/sine)) : vector(Zero);
}

//- The point with the largest value; of those that share it the first in space,
//  whatever the order of the ranks
static label firstOfMost(const scalarField& values, const pointField& points)
{
    const auto isBefore = [](const point& a, const point& b)
    {
        return
            a.x() != b.x() ? a.x() < b.x()
          : a.y() != b.y() ? a.y() < b.y()
          : a.z() < b.z();
    };
    const scalar limit = (1 - samePlace)*max(values);
    label first = -1;
    forAll(values, i)
    {
        if
        (
            values[i] >= limit
         && (first < 0 || isBefore(points[i], points[first]))
        )
        {
            first = i;
        }
    }
    return first;
}

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
        const label next = firstOfMost(distance, allPoints_);
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


Foam::vectorField Foam::interfaceFunctions::termGradients(const point& x) const
{
    const label n = size();
    vectorField gradient(n + 1 + directions_.size(), Zero);
    for (label i = 0; i < n; ++i)
    {
        const vector r((x - controlPoints_[i])/extent_);
        gradient[i] = 3*mag(r)*r/extent_;
    }
    forAll(directions_, i)
    {
        gradient[n + 1 + i] = directions_[i];
    }
    return gradient;
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


void Foam::interfaceFunctions::setValues(const List<scalarField>& weight)
{
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


Foam::vector Foam::interfaceFunctions::normal(const point& x) const
{
    const scalar limit = samePlace*extent_;
    vector sum(Zero);
    vector largest(Zero);
    forAll(allPoints_, i)
    {
        if (mag(allPoints_[i] - x) <= limit)
        {
            sum += allAreas_[i];
            if (magSqr(allAreas_[i]) > magSqr(largest))
            {
                largest = allAreas_[i];
            }
        }
    }
    return normalised(mag(sum) > cancels*mag(largest) ? sum : largest);
}


void Foam::interfaceFunctions::setSlopes(const List<scalarField>& weight)
{
    frames_.setSize(size());
    slopes_ = List<List<Pair<scalar>>>(size(), List<Pair<scalar>>(size()));
    forAll(frames_, i)
    {
        const point& x = controlPoints_[i];
        frames_[i] = frame(normal(x));
        const vectorField gradient(termGradients(x));
        forAll(weight, function)
        {
            const vector slope(sum(weight[function]*gradient));
            slopes_[i][function].first() = slope & frames_[i].cx();
            slopes_[i][function].second() = slope & frames_[i].cy();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceFunctions::interfaceFunctions
(
    const pointField& points,
    const vectorField& areas,
    const label n,
    const bool rotation
)
:
    points_(points)
{
    const List<vectorField> ofRanks(onAllRanks(points));
    offset_ = 0;
    for (label rank = 0; rank < Pstream::myProcNo(); ++rank)
    {
        offset_ += ofRanks[rank].size();
    }
    allPoints_ = inOne(ofRanks);
    allAreas_ = inOne(onAllRanks(areas));

    chooseControls(n);
    const List<scalarField> weight(weights());
    setValues(weight);
    if (rotation)
    {
        setSlopes(weight);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::interfaceFunctions::nNumbers
(
    const label nPoints,
    const label n,
    const bool rotation
)
{
    // Values at the points, two matrices of the weights while they are made,
    // and the slopes along two tangents
    return scalar(n)*(nPoints + 2*scalar(n) + (rotation ? 2*scalar(n) : 0));
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


Foam::vectorField Foam::interfaceFunctions::rotations
(
    const vectorField& coefficients
) const
{
    vectorField result(size(), Zero);
    forAll(result, i)
    {
        vector first(frames_[i].cx());
        vector second(frames_[i].cy());
        forAll(coefficients, function)
        {
            first += slopes_[i][function].first()*coefficients[function];
            second += slopes_[i][function].second()*coefficients[function];
        }
        const vector area(first ^ second);
        if (mag(area) > SMALL)
        {
            const tensor turned(tensor(first, second, normalised(area)).T());
            result[i] =
                rotationVector(rotationOf(turned & frames_[i].T()));
        }
    }
    return result;
}


template<class Type>
Foam::Field<Type> Foam::interfaceFunctions::coefficients
(
    const Field<Type>& values
) const
{
    Field<Type> coefficients(size(), Zero);
    forAll(controls_, i)
    {
        const label local = controls_[i] - offset_;
        if (local >= 0 && local < values.size())
        {
            coefficients[i] = values[local];
        }
    }
    reduce(coefficients, sumOp<Field<Type>>());
    return coefficients;
}


bool Foam::interfaceFunctions::areWithin
(
    const interfaceFunctions& others
) const
{
    // Splines are those of the others that have no part of their linear
    // functions, of which there must not be more
    return
        size() <= others.size()
     && controls_ == SubList<label>(others.controls_, size())
     && directions_.size() == others.directions_.size();
}


Foam::scalar Foam::interfaceFunctions::residual
(
    const vectorField& values,
    const vectorField& coefficients
) const
{
    vectorField missed(values);
    forAll(values_, function)
    {
        forAll(missed, i)
        {
            missed[i] -= values_[function][i]*coefficients[function];
        }
    }
    return gMax(mag(missed)());
}


// ************************************************************************* //
