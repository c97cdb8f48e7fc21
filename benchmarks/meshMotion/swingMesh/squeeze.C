// SPDX-License-Identifier: GPL-3.0-or-later
#include "squeeze.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::squeeze::squeeze(const dictionary& dict)
:
    root_(dict.get<point>("root")),
    tip_(dict.get<point>("tip")),
    span_(dict.getOrDefault<vector>("span", Zero))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::squeeze::displacement
(
    const pointField& points,
    const scalar depth
) const
{
    const scalar length = mag(tip_ - root_);
    const vector axis((tip_ - root_)/length);
    vectorField displacement(points.size());
    forAll(points, pointi)
    {
        const vector offset(points[pointi] - root_);
        const scalar s = (offset & axis)/length;
        const vector fromAxis
        (
            offset - axis*(axis & offset) - span_*(span_ & offset)
        );
        displacement[pointi] =
            -depth*sqr(sin(constant::mathematical::pi*s))*normalised(fromAxis);
    }
    return displacement;
}


// ************************************************************************* //
