// SPDX-License-Identifier: GPL-3.0-or-later
#include "restartFiles.H"
#include "surfaceFields.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Whether a coupled patch of any rank is displaced
bool isDisplaced(const pointVectorField& displacement, const labelList& patches)
{
    bool displaced = false;
    for (const label patchi : patches)
    {
        const vectorField values
        (
            displacement.boundaryField()[patchi].patchInternalField()
        );
        for (const vector& v : values)
        {
            displaced = displaced || v != vector::zero;
        }
    }
    return returnReduce(displaced, orOp<bool>());
}


//- Warn of such a field that the solver has, but not from a file
template<class Field>
void warnIfMissing
(
    const fvMesh& mesh,
    const word& name,
    const dictionary& dict
)
{
    if (!mesh.foundObject<Field>(name))
    {
        return;
    }
    const word& time = mesh.time().timeName();
    IOobject file
    (
        name, time, mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!returnReduce(file.typeHeaderOk<Field>(false), andOp<bool>()))
    {
        IOWarningInFunction(dict)
            << "the start time has no file " << time << '/' << name
            << ": the solver interpolates it anew, so the run does not "
            << "continue exactly as it would have" << nl
            << "    Start from a time that has all files which the solver "
            << "has written" << endl;
    }
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::restartFiles::check
(
    const fvMesh& mesh,
    const pointVectorField& displacement,
    const labelList& patches,
    const dictionary& dict
)
{
    if (!isDisplaced(displacement, patches))
    {
        return;
    }
    const word& time = mesh.time().timeName();
    if
    (
        returnReduce(mesh.pointsInstance() != time, orOp<bool>())
    )
    {
        FatalIOErrorInFunction(dict)
            << "the start time has no points of the mesh, " << time
            << "/polyMesh/points, though " << time << "/pointDisplacement "
            << "displaces the coupled patches: the fluid would start on the "
            << "mesh of '" << mesh.pointsInstance().c_str() << "'" << nl
            << "    Start from a time that has both, as OpenFOAM writes them, "
            << "or from an undeformed mesh" << exit(FatalIOError);
    }
    warnIfMissing<surfaceScalarField>(mesh, "phi", dict);
    warnIfMissing<surfaceVectorField>(mesh, "Uf", dict);
    warnIfMissing<surfaceVectorField>(mesh, "rhoUf", dict);
}


std::vector<double> Foam::restartFiles::keptTimes(const Time& runTime)
{
    std::vector<double> kept;
    if (runTime.controlDict().lookupOrDefault<label>("purgeWrite", 0) <= 0)
    {
        return kept;
    }
    for (const fileName& folder : {runTime.path(), runTime.globalPath()})
    {
        for (const instant& time : Time::findTimes(folder, "constant"))
        {
            if (time.name() != "constant")
            {
                kept.push_back(time.value());
            }
        }
    }
    return kept;
}


// ************************************************************************* //
