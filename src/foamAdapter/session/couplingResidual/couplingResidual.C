// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingResidual.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Where the mesh keeps the solvers' residuals: in a member of its own in
//  later versions of OpenFOAM ...
template<class Mesh>
auto performanceStore(const Mesh& mesh, int)
 -> decltype(mesh.data().solverPerformanceDict(), mesh.data())
{
    return mesh.data();
}

//- ... and in a base class in earlier ones
template<class Mesh>
const Mesh& performanceStore(const Mesh& mesh, long)
{
    return mesh;
}

//- No more the final outer corrector: a state of the mesh in later versions ...
template<class Mesh>
auto endFinalIteration(Mesh& mesh, int)
 -> decltype(mesh.data().setFinalIteration(false))
{
    return mesh.data().setFinalIteration(false);
}

//- ... and an entry of a base class in earlier ones
template<class Mesh>
void endFinalIteration(Mesh& mesh, long)
{
    mesh.data::remove("finalIteration");
}

//- A component of the velocity that is smaller, relative to the largest, is
//  what the linear solvers leave across a plane flow in space
constexpr Foam::scalar leastComponent = 1e-4;

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::couplingResidual::readTolerance() const
{
    if (isExplicit())
    {
        return 1;
    }

    const dictionary controls(pimple_.dict());
    if (!controls.lookupOrDefault("moveMeshOuterCorrectors", false))
    {
        FatalIOErrorInFunction(controls)
            << "'moveMeshOuterCorrectors' is off: the mesh could not follow "
            << "the structure within a time step" << nl
            << "    add 'moveMeshOuterCorrectors yes;'" << exit(FatalIOError);
    }

    const word& key = field_.name();
    const dictionary& residualControl =
        controls.subOrEmptyDict("residualControl");
    const dictionary* control = residualControl.findDict(key, keyType::REGEX);
    if (!control)
    {
        FatalIOErrorInFunction(controls)
            << "residualControl has no entry '" << key << "': the time step "
            << "would end without the structure having converged" << nl
            << "    add '" << key << " { tolerance 1e-4; relTol 0; }', or set "
            << "'nOuterCorrectors 1' for explicit coupling"
            << exit(FatalIOError);
    }
    const scalar tolerance = control->get<scalar>("tolerance");
    if (tolerance <= 0 || tolerance >= 1)
    {
        FatalIOErrorInFunction(*control)
            << "the tolerance is " << tolerance
            << ": it must lie between 0 and 1" << exit(FatalIOError);
    }
    if (control->lookupOrDefault<scalar>("relTol", 0) > 0)
    {
        FatalIOErrorInFunction(*control)
            << "'relTol' is not 0: the coupling residual is relative already, "
            << "and a step could end unconverged" << exit(FatalIOError);
    }
    return tolerance;
}


template<class Type>
void Foam::couplingResidual::enterZero(const wordList& names)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    const fvMesh& mesh = field_.mesh();
    for (const word& name : names)
    {
        if (mesh.foundObject<fieldType>(name))
        {
            performanceStore(mesh, 0).setSolverPerformance
            (
                name,
                SolverPerformance<Type>("rejected", name)
            );
        }
    }
}


const Foam::dictionary* Foam::couplingResidual::momentumControl
(
    const dictionary& controls
) const
{
    return controls.subDict("residualControl").findDict
    (
        UName_,
        keyType::REGEX
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingResidual::couplingResidual
(
    const word& name,
    const word& UName,
    const fvMesh& mesh,
    const pimpleControl& pimple
)
:
    pimple_(pimple),
    UName_(UName),
    field_
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    ),
    tolerance_(readTolerance())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::couplingResidual::isExplicit() const
{
    return pimple_.nCorrPIMPLE() == 1;
}


void Foam::couplingResidual::enter(const scalar residual)
{
    const word& name = field_.name();
    performanceStore(field_.mesh(), 0).setSolverPerformance
    (
        name,
        SolverPerformance<scalar>
        (
            "coupling",
            name,
            residual,
            residual,
            1,
            false,
            false
        )
    );
}


void Foam::couplingResidual::endLoop()
{
    enter(0);
    const wordList names
    (
        performanceStore(field_.mesh(), 0).solverPerformanceDict().toc()
    );
    enterZero<scalar>(names);
    enterZero<vector>(names);
    enterZero<symmTensor>(names);
}


void Foam::couplingResidual::reopenLoop(const scalar residual)
{
    // PIMPLE keeps to itself that the next end of its loop is the last
    struct loopState
    :
        pimpleControl
    {
        static bool pimpleControl::* converged()
        {
            return &loopState::converged_;
        }
    };

    const_cast<pimpleControl&>(pimple_).*loopState::converged() = false;
    endFinalIteration(const_cast<fvMesh&>(field_.mesh()), 0);
    enter(residual);
}


Foam::vector Foam::couplingResidual::momentumComponents() const
{
    List<SolverPerformance<vector>> performance;
    const dictionary& all =
        performanceStore(field_.mesh(), 0).solverPerformanceDict();
    if
    (
        !all.readIfPresent(UName_, performance)
     || performance.empty()
    )
    {
        return Zero;   // without a momentum predictor there is none
    }
    return performance.last().initialResidual();
}


Foam::scalar Foam::couplingResidual::momentum() const
{
    const vectorField& U =
        field_.mesh().lookupObject<volVectorField>(UName_).primitiveField();
    const vector squares(gSum(cmptMultiply(U, U)));
    const scalar least = sqr(leastComponent)*cmptMax(squares);
    const vector residuals(momentumComponents());
    scalar largest = 0;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (squares[cmpt] > least)
        {
            largest = max(largest, residuals[cmpt]);
        }
    }
    return largest;
}


bool Foam::couplingResidual::controlsMomentum() const
{
    const dictionary controls(pimple_.dict());
    return momentumControl(controls);
}


bool Foam::couplingResidual::momentumConverged() const
{
    const dictionary controls(pimple_.dict());
    const dictionary* control = momentumControl(controls);
    return
        !control
     || cmptMax(momentumComponents()) < control->get<scalar>("tolerance");
}


// ************************************************************************* //
