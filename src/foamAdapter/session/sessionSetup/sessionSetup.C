// SPDX-License-Identifier: GPL-3.0-or-later
#include "sessionSetup.H"
#include "structureDisplacementPointPatchVectorField.H"
#include "movingWallVelocityFvPatchVectorField.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Every name of the entry 'patches' has to match a patch
void checkNames
(
    const wordRes& names,
    const polyBoundaryMesh& boundary,
    const dictionary& dict
)
{
    for (const wordRe& name : names)
    {
        if (boundary.patchSet(wordRes(1, name), false).empty())
        {
            FatalIOErrorInFunction(dict)
                << "no patch matches '" << name << "' of the entry 'patches'"
                << nl << "    The mesh has: " << flatOutput(boundary.names())
                << exit(FatalIOError);
        }
    }
}


//- The mesh has to follow the structure on this patch
void checkMotion
(
    const pointPatchVectorField& condition,
    const word& patchName,
    const dictionary& dict
)
{
    if (!isA<structureDisplacementPointPatchVectorField>(condition))
    {
        FatalIOErrorInFunction(dict)
            << "pointDisplacement has '" << condition.type()
            << "' on the coupled patch '" << patchName << "'" << nl
            << "    it must be '"
            << structureDisplacementPointPatchVectorField::typeName
            << "'" << exit(FatalIOError);
    }
}


//- The fluid should move with the wall
void checkVelocity
(
    const fvPatchVectorField& condition,
    const word& UName,
    const dictionary& dict
)
{
    if (!isA<movingWallVelocityFvPatchVectorField>(condition))
    {
        IOWarningInFunction(dict)
            << UName << " has '" << condition.type()
            << "' on the coupled patch '" << condition.patch().name()
            << "': a wall that moves with the structure has "
            << "'movingWallVelocity'" << endl;
    }
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::sessionSetup::selectPatches
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const wordRes names(dict.get<wordRes>("patches"));
    const polyBoundaryMesh& boundary = mesh.boundaryMesh();
    checkNames(names, boundary, dict);

    const labelList patches(boundary.patchSet(names).sortedToc());
    label nFaces = 0;
    for (const label patchi : patches)
    {
        if (polyPatch::constraintType(boundary[patchi].type()))
        {
            FatalIOErrorInFunction(dict)
                << "patch '" << boundary[patchi].name() << "' of the entry "
                << "'patches' is of type " << boundary[patchi].type()
                << ": a structure needs a wall" << exit(FatalIOError);
        }
        nFaces += boundary[patchi].size();
    }
    if (returnReduce(nFaces, sumOp<label>()) == 0)
    {
        FatalIOErrorInFunction(dict)
            << "the entry 'patches' names no patch with faces"
            << exit(FatalIOError);
    }
    return patches;
}


const Foam::pointVectorField& Foam::sessionSetup::findPointDisplacement
(
    const fvMesh& mesh,
    const dictionary& dict,
    const labelList& patches,
    const word& UName
)
{
    if (!mesh.foundObject<pointVectorField>("pointDisplacement"))
    {
        FatalIOErrorInFunction(dict)
            << "no field 'pointDisplacement': the mesh does not move by "
            << "displacement" << nl
            << "    use a displacement motion solver, such as "
            << "displacementLaplacian, in constant/dynamicMeshDict"
            << exit(FatalIOError);
    }
    const pointVectorField& displacement =
        mesh.lookupObject<pointVectorField>("pointDisplacement");
    const volVectorField& U = mesh.lookupObject<volVectorField>(UName);

    for (const label patchi : patches)
    {
        checkMotion
        (
            displacement.boundaryField()[patchi],
            mesh.boundary()[patchi].name(),
            dict
        );
        checkVelocity(U.boundaryField()[patchi], UName, dict);
    }
    return displacement;
}


// ************************************************************************* //
