// SPDX-License-Identifier: GPL-3.0-or-later
#include "movingBoundary.H"
#include "structureDisplacementPointPatchVectorField.H"
#include "fixedValuePointPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Names, with spaces between them
static string spaced(const wordList& names)
{
    string text;
    for (const word& name : names)
    {
        text += (text.empty() ? "" : " ") + name;
    }
    return text;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::movingBoundary::selectPatches
(
    const dictionary& coeffs
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    if (coeffs.found("patches"))
    {
        const wordRes names(coeffs.get<wordRes>("patches"));
        const labelList selected(patches.patchSet(names).sortedToc());
        if (selected.empty())
        {
            FatalIOErrorInFunction(coeffs)
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
                displacement_.boundaryField()[patchi]
            )
        )
        {
            selected.append(patchi);
        }
    }
    if (selected.empty())
    {
        FatalIOErrorInFunction(coeffs)
            << "no patch of pointDisplacement has the condition '"
            << structureDisplacementPointPatchVectorField::typeName << "'"
            << nl << "    name the patches that move in an entry 'patches'"
            << exit(FatalIOError);
    }
    return selected;
}


Foam::labelList Foam::movingBoundary::selectPoints() const
{
    labelHashSet points;
    for (const label patchi : patches_)
    {
        points.insert(mesh_.boundaryMesh()[patchi].meshPoints());
    }
    return points.sortedToc();
}


Foam::wordList Foam::movingBoundary::othersThatMove() const
{
    labelHashSet moving;
    forAll(displacement_.boundaryField(), patchi)
    {
        const auto* values = isA<fixedValuePointPatchVectorField>
        (
            displacement_.boundaryField()[patchi]
        );
        if
        (
            values && values->size() > 0 && max(mag(*values)) > 0
         && !patches_.found(patchi)
        )
        {
            moving.insert(patchi);
        }
    }

    DynamicList<word> found;
    if (returnReduce(!moving.empty(), orOp<bool>()))
    {
        // Those of processors come after the mesh's, which all ranks share
        const label nPatches = mesh_.boundaryMesh().nNonProcessor();
        for (label patchi = 0; patchi < nPatches; ++patchi)
        {
            if (returnReduce(moving.found(patchi), orOp<bool>()))
            {
                found.append(mesh_.boundaryMesh()[patchi].name());
            }
        }
    }
    wordList names;
    names.transfer(found);
    return names;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::movingBoundary::movingBoundary
(
    const pointVectorField& displacement,
    const dictionary& coeffs
)
:
    displacement_(displacement),
    mesh_(refCast<const fvMesh>(displacement.mesh()())),
    patches_(selectPatches(coeffs)),
    points_(selectPoints())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::movingBoundary::names() const
{
    wordList names(patches_.size());
    forAll(names, i)
    {
        names[i] = mesh_.boundaryMesh()[patches_[i]].name();
    }
    return names;
}


Foam::vectorField Foam::movingBoundary::inPlane(vectorField vectors) const
{
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (mesh_.geometricD()[cmpt] < 0)
        {
            vectors.replace(cmpt, 0);
        }
    }
    return vectors;
}


Foam::pointField Foam::movingBoundary::places(const pointField& points) const
{
    return inPlane(vectorField(points, points_));
}


Foam::vectorField Foam::movingBoundary::areas(const pointField& points) const
{
    vectorField onPoints(mesh_.nPoints(), Zero);
    for (const label patchi : patches_)
    {
        for (const face& f : mesh_.boundaryMesh()[patchi])
        {
            const vector part(f.areaNormal(points)/f.size());
            for (const label pointi : f)
            {
                onPoints[pointi] += part;
            }
        }
    }
    return vectorField(onPoints, points_);
}


Foam::vectorField Foam::movingBoundary::displacement() const
{
    vectorField onPoints(mesh_.nPoints(), Zero);
    for (const label patchi : patches_)
    {
        const auto& values = refCast<const fixedValuePointPatchVectorField>
        (
            displacement_.boundaryField()[patchi]
        );
        UIndirectList<vector>
        (
            onPoints,
            mesh_.boundaryMesh()[patchi].meshPoints()
        ) = values;
    }
    return vectorField(onPoints, points_);
}


Foam::string Foam::movingBoundary::obstacle() const
{
    const wordList others(othersThatMove());
    if (!others.empty())
    {
        return "patches that are not among 'patches' (" + spaced(names())
          + ") move: " + spaced(others);
    }
    return string();
}


// ************************************************************************* //
