// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingResidual.H"
#include "openfoamVersion.H"
#include "residualCriteria.H"

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingResidual::couplingResidual
(
    const word& name,
    const fvMesh& mesh,
    const pimpleControl& pimple
)
:
    pimple_(pimple),
    algorithm_(pimple.dict().dictName()),
    nCorrectors_(pimple.nCorrPIMPLE()),
    isExplicit_(nCorrectors_ == 1),
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

void Foam::couplingResidual::reportChanges()
{
    const label nCorrectors = pimple_.nCorrPIMPLE();
    if (nCorrectors == nCorrectors_)
    {
        return;
    }
    Info<< "structureCoupling: nOuterCorrectors is now " << nCorrectors
        << " instead of " << nCorrectors_;
    if (isExplicit_)
    {
        Info<< "; the coupling stays explicit until the next start, with one "
            << "coupling iteration per time step";
    }
    else if (nCorrectors == 1)
    {
        Info<< "; the coupling stays strong until the next start, and one "
            << "outer corrector cannot converge it";
    }
    Info<< endl;
    nCorrectors_ = nCorrectors;
}


Foam::scalar Foam::couplingResidual::toleranceNow() const
{
    const dictionary* const control =
        residualCriteria::controlsNow(field_.mesh(), algorithm_).findDict
        (
            field_.name(),
            keyType::REGEX
        );
    return control ? control->get<scalar>("tolerance") : tolerance_;
}


void Foam::couplingResidual::enter(const scalar residual)
{
    const word& name = field_.name();
    // The structure decides with the tolerance of the start
    const scalar scaled =
        isExplicit_ ? 0 : residual*toleranceNow()/tolerance_;
    performanceStore(field_.mesh(), 0).setSolverPerformance
    (
        name,
        SolverPerformance<scalar>
        (
            "coupling",
            name,
            scaled,
            scaled,
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


// ************************************************************************* //
