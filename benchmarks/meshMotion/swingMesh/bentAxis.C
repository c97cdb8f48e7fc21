// SPDX-License-Identifier: GPL-3.0-or-later
#include "bentAxis.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Pieces of the axis
constexpr label nPieces = 2000;

//- The slope that has no angle, almost
constexpr scalar steepest = 0.999;

//- Slope of a cantilever's mode that is 1 at the tip, over that at rest
//  \param b  root of cos(b) cosh(b) = -1
static scalar modeSlope(const scalar b, const scalar s)
{
    const scalar sigma = (cosh(b) + cos(b))/(sinh(b) + sin(b));
    const scalar tip = cosh(b) - cos(b) - sigma*(sinh(b) - sin(b));
    const scalar z = b*s;
    return b*(sinh(z) + sin(z) - sigma*(cosh(z) - cos(z)))/tip;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::bentAxis::angle
(
    const scalar s,
    const scalar amplitude
) const
{
    const scalar slope =
        amplitude
       *(
            (1 - secondMode_)*modeSlope(1.8751040687, s)
          + secondMode_*modeSlope(4.6940911330, s)
        );
    return asin(max(-steepest, min(steepest, slope)));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bentAxis::bentAxis(const dictionary& dict)
:
    root_(dict.get<point>("root")),
    tip_(dict.get<point>("tip")),
    length_(mag(tip_ - root_)),
    secondMode_(dict.get<scalar>("secondMode"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::bentAxis::displacement
(
    const pointField& points,
    const scalar tip
) const
{
    scalarField angles(nPieces + 1);
    scalarField along(nPieces + 1, Zero), across(nPieces + 1, Zero);
    forAll(angles, i)
    {
        angles[i] = angle(scalar(i)/nPieces, tip/length_);
        if (i > 0)
        {
            const scalar middle = 0.5*(angles[i - 1] + angles[i]);
            along[i] = along[i - 1] + cos(middle)*length_/nPieces;
            across[i] = across[i - 1] + sin(middle)*length_/nPieces;
        }
    }

    const vector axis((tip_ - root_)/length_);
    const vector normal(vector(0, 0, 1) ^ axis);
    vectorField displacement(points.size());
    forAll(points, pointi)
    {
        const vector offset(points[pointi] - root_);
        const scalar s = max(scalar(0), min(length_, offset & axis));
        const label i = label(s/length_*nPieces + 0.5);
        const scalar beyond = (offset & axis) - s;
        const scalar height = offset & normal;
        const scalar c = cos(angles[i]), n = sin(angles[i]);
        displacement[pointi] =
            axis*(along[i] - s + beyond*(c - 1) - height*n)
          + normal*(across[i] + beyond*n + height*(c - 1));
    }
    return displacement;
}


// ************************************************************************* //
