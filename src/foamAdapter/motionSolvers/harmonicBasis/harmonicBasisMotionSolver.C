// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonicBasisMotionSolver.H"
#include "addToRunTimeSelectionTable.H"
#include "clockTime.H"
#include "pointConstraints.H"
#include "dictionaryChecks.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(harmonicBasisMotionSolver, 0);

    addToRunTimeSelectionTable
    (
        motionSolver,
        harmonicBasisMotionSolver,
        dictionary
    );

    addToRunTimeSelectionTable
    (
        displacementMotionSolver,
        harmonicBasisMotionSolver,
        displacement
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Fit error of one function for each point, over the smallest cell height
constexpr scalar roundOff = 1e-6;

//- The mesh, if the start time has the field that moves it
const polyMesh& withPointDisplacement(const polyMesh& mesh)
{
    const word& time = mesh.time().timeName();
    IOobject file
    (
        "pointDisplacement",
        time,
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    const bool isThere = file.typeHeaderOk<pointVectorField>(false);
    if (!returnReduce(isThere, andOp<bool>()))
    {
        FatalErrorInFunction
            << "no file " << time << "/pointDisplacement: harmonicBasis moves "
            << "the mesh by that field" << nl
            << "    a run from rest needs it with its boundary conditions; "
            << "to continue a run, start from a time that has it"
            << exit(FatalError);
    }
    return mesh;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::harmonicBasisMotionSolver::checkedCoeffs() const
{
    requireKnownEntries
    (
        coeffDict(),
        {
            "patches",
            "nFunctions",
            "diffusivity",
            "rotation",
            "fitLimit",
            "memoryLimit",
            "fallback",
            "fallbackSweeps"
        }
    );
    return coeffDict();
}


Foam::string Foam::harmonicBasisMotionSolver::diffusivity
(
    const string& ownPower
) const
{
    OStringStream type;
    if (coeffDict().found("diffusivity"))
    {
        for (const token& part : coeffDict().lookup("diffusivity"))
        {
            type << part << ' ';
        }
    }
    else
    {
        type << ownPower.c_str() << "inverseDistance " << boundary_.names();
    }
    return type.str();
}


Foam::string Foam::harmonicBasisMotionSolver::excess(const label wanted) const
{
    // There are no more functions than points
    const label n =
        min(wanted, returnReduce(boundary_.points().size(), sumOp<label>()));
    const scalar memory =
        harmonicBasis::memory(boundary_, constraints_, n, rotation_);
    if (memory <= memoryLimit_)
    {
        return string();
    }
    OStringStream reason;
    reason
        << n << " functions can take " << memory/1e6
        << " MB on a rank, more than the 'memoryLimit' of "
        << memoryLimit_/1e6
        << "; more ranks need less on each, fewer functions"
        << " a larger 'fitLimit'";
    return reason.str();
}


Foam::labelList Foam::harmonicBasisMotionSolver::firstStages() const
{
    labelList stages;
    if (state_.found("nFunctions"))
    {
        // A dictionary cannot be read with a binary list
        IStringStream list(state_.get<string>("nFunctions"));
        list >> stages;
    }
    const label wanted = coeffDict().getCheckOrDefault<label>
    (
        "nFunctions",
        32,
        labelMinMax::ge(1)
    );
    if (stages.empty() || stages.last() < wanted)
    {
        stages.append(wanted);
    }
    return stages;
}


Foam::string Foam::harmonicBasisMotionSolver::build(const labelUList& stages)
{
    const string reason(excess(stages.last()));
    if (reason.empty())
    {
        const clockTime clock;
        for (const label n : stages)
        {
            IStringStream diffusivityStream(diffusivity("power 0.5 "));
            basis_.reset
            (
                new harmonicBasis
                (
                    boundary_,
                    constraints_,
                    points0(),
                    n,
                    diffusivityStream,
                    rotation_,
                    basis_.get()
                )
            );
        }
        OStringStream list;
        list << stages_;
        state_.set("nFunctions", string(list.str()));
        Info<< typeName << ": ";
        basis_->writeSize(Info);
        Info<< ", built in " << clock.elapsedTime() << " s" << nl << endl;
    }
    return reason;
}


Foam::string Foam::harmonicBasisMotionSolver::addFunctions
(
    scalar missed,
    const scalar allowed
)
{
    const pointField points(boundary_.places(points0()));
    const vectorField areas(boundary_.areas(points0()));
    const vectorField displacement(boundary_.displacement());
    label n = basis_->size();
    bool isComplete = basis_->isComplete();
    while
    (
        missed > allowed
     && !(isComplete && missed <= roundOff*basis_->cellHeight())
    )
    {
        OStringStream misses;
        misses
            << n << " functions miss the boundary's motion by " << missed
            << " m, 'fitLimit' allows " << allowed << " m, and ";
        const string reason
        (
            isComplete
          ? string("there is one for each point of the boundary")
          : excess(2*n)
        );
        if (!reason.empty())
        {
            return misses.str() + reason;
        }
        const interfaceFunctions more(points, areas, 2*n, false);
        missed = more.residual(displacement, more.coefficients(displacement));
        n = more.size();
        isComplete = more.isComplete();
    }
    if (n == basis_->size())
    {
        return string();
    }
    stages_.append(n);
    const string reason(build(labelList(1, n)));
    basis_->fit();
    return reason;
}


Foam::string Foam::harmonicBasisMotionSolver::follow()
{
    string reason(constraints_.obstacle());
    if (reason.empty())
    {
        reason = boundary_.obstacle();
    }
    if (reason.empty() && !basis_.valid())
    {
        reason = build(stages_);
    }
    if (reason.empty())
    {
        const scalar missed = basis_->fit();
        const scalar allowed = fitLimit_*basis_->cellHeight();
        if (missed > allowed)
        {
            reason = addFunctions(missed, allowed);
        }
    }
    return reason;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::harmonicBasisMotionSolver::harmonicBasisMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict
)
:
    displacementMotionSolver(withPointDisplacement(mesh), dict, typeName)
{}


Foam::harmonicBasisMotionSolver::harmonicBasisMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict,
    const pointVectorField& pointDisplacement,
    const pointIOField& points0
)
:
    displacementMotionSolver(mesh, dict, pointDisplacement, points0, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::pointField> Foam::harmonicBasisMotionSolver::curPoints() const
{
    if (fallback_.motion())
    {
        fallback_.motion()->apply();
    }
    else
    {
        basis_->apply(pointDisplacement_.primitiveFieldRef());
        pointConstraints::New(pointDisplacement_.mesh())
            .constrainDisplacement(pointDisplacement_, false);
    }
    constraints_.keepInPlanes(pointDisplacement_.primitiveFieldRef());

    tmp<pointField> points(points0() + pointDisplacement_.primitiveField());
    twoDCorrectPoints(points.ref());
    return points;
}


void Foam::harmonicBasisMotionSolver::solve()
{
    pointDisplacement_.boundaryFieldRef().updateCoeffs();
    if (!fallback_.motion())
    {
        const string reason(follow());
        if (!reason.empty())
        {
            fallback_.begin(reason);
            basis_.clear();
        }
    }
    if (fallback_.motion())
    {
        fallback_.motion()->solve();
    }
}


void Foam::harmonicBasisMotionSolver::updateMesh(const mapPolyMesh& map)
{
    displacementMotionSolver::updateMesh(map);
    constraints_.updateMesh();
    if (fallback_.motion())
    {
        fallback_.motion()->updateMesh();
    }
    else
    {
        basis_.clear();
        fallback_.begin("the topology of the mesh has changed");
    }
}


// ************************************************************************* //
