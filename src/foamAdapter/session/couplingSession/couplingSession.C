// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingSession.H"
#include "controlAdvice.H"
#include "openfoamVersion.H"
#include "restartFiles.H"
#include "sessionSetup.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(couplingSession, 0);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

tokay::channel::Interface Foam::couplingSession::describe(const word& name)
{
    tokay::channel::Interface message;
    message.name = name;
    message.tolerance = residual_.tolerance();
    message.audit = audit_.active();
    message.startTime = mesh_.time().startTime().value();
    message.endTime = mesh_.time().endTime().value();
    message.deltaT = mesh_.time().deltaTValue();
    message.retries = step_.retries();
    interface_.describe(pointDisplacement_, message);
    return message;
}


void Foam::couplingSession::announce() const
{
    if (residual_.isExplicit())
    {
        Info<< "    explicit coupling, one coupling iteration per time step"
            << endl;
        return;
    }
    Info<< "    strong coupling, tolerance " << residual_.tolerance()
        << endl;
    pressureTolerance_.announce();
    predictor_.announce();
    controlAdvice::report(mesh_, pimple_, UName());
}


void Foam::couplingSession::startStructure
(
    const tokay::channel::Interface& message
)
{
    tokay::channel::Accepted accepted(structure_.start(message));
    fromMaster(accepted.limitsForce);
    Info<< accepted.report.c_str() << endl;
    if
    (
        !residual_.isExplicit()
     && !criteria_.controlsMomentum()
     && !accepted.limitsForce
    )
    {
        controlAdvice::reportNoForce(pimple_, UName());
        finalCorrector_.watchMomentum();
    }
}


void Foam::couplingSession::beginTimeStep()
{
    step_.begin();
    step_.current().phases.enter(phaseClock::phase::coupling);
    hasEnded_ = false;
    preset_.completeControls();
    residual_.reportChanges();
    audited_ = false;
    rates_.beginTimeStep();
    force_.beginTimeStep();
    predictor_.beginTimeStep();
    coupledCorrector_ = 0;

    const scalar start = stepController::wallClock();
    tokay::channel::BeginStep message;
    message.step = step_.number();
    message.time = mesh_.time().value();
    message.deltaT = mesh_.time().deltaTValue();

    displacement_ = distribute
    (
        structure_.exchange
        (
            message,
            "the structure's predicted displacements, step "
          + std::to_string(message.step)
        ).values
    );
    nextDisplacement_ = displacement_;
    step_.current().structureSeconds += stepController::wallClock() - start;
}


void Foam::couplingSession::endMeshMotion(const string& invertedCells)
{
    step_.current().phases.enter(phaseClock::phase::fluxes);
    if (!invertedCells.empty())
    {
        step_.failMesh(invertedCells);
    }
}


bool Foam::couplingSession::isDue() const
{
    return
        !residual_.isExplicit()
     && (
            interval_.isDue(corrector_ - coupledCorrector_)
         || corrector_ == pimple_.nCorrPIMPLE() - 1
        );
}


Foam::vectorField Foam::couplingSession::evaluateForces(const bool final)
{
    vectorField forces(force_(patches()));
    const string nonFinite(force_.describeNonFinite(patches(), forces));
    if (!nonFinite.empty())
    {
        step_.fail
        (
            nonFinite, ": reduce deltaT, or check the mesh near that place"
        );
    }
    else if (final && audit_.active())
    {
        audit_.measure(interface_, forces);
    }
    return forces;
}


std::vector<double> Foam::couplingSession::collect
(
    const vectorField& forces
)
{
    const scalar start = stepController::wallClock();
    std::vector<double> values(interface_.collect(forces));
    step_.current().gatherSeconds += stepController::wallClock() - start;
    return values;
}


Foam::List<Foam::vectorField> Foam::couplingSession::distribute
(
    const std::vector<double>& values
)
{
    const scalar start = stepController::wallClock();
    List<vectorField> ofPatches(interface_.distribute(values));
    step_.current().gatherSeconds += stepController::wallClock() - start;
    return ofPatches;
}


void Foam::couplingSession::iterate(const bool final, const bool ifConverged)
{
    const scalar start = stepController::wallClock();
    const vectorField forces(evaluateForces(final));
    if (step_.hasFailed())
    {
        return;
    }

    stepController::statistics& current = step_.current();
    tokay::channel::Forces message;
    message.final = final;
    message.ifConverged = ifConverged;
    message.write = final && mesh_.time().writeTime();
    if (criteria_.solvesMomentum())
    {
        message.fluidResidual = current.fluidResidual;
    }
    message.values = collect(forces);
    if (message.write)
    {
        message.fluidTimes = restartFiles::keptTimes(mesh_.time());
    }
    const scalar sent = stepController::wallClock();

    receive
    (
        structure_.exchange
        (
            message,
            "the structure's displacements, step "
          + std::to_string(step_.number()) + ", outer corrector "
          + std::to_string(corrector_)
        )
    );
    coupledCorrector_ = corrector_;
    ++current.couplingIterations;
    current.forceSeconds += sent - start;
    current.structureSeconds += stepController::wallClock() - sent;
}


void Foam::couplingSession::receive
(
    const tokay::channel::Displacements& solution
)
{
    using tokay::channel::State;

    label state = static_cast<label>(solution.state);
    fromMaster(state);
    if (state == static_cast<label>(State::rejected))
    {
        string reason(solution.reason);
        fromMaster(reason);
        step_.fail(reason, string());
        return;
    }
    scalar residual = solution.residual;
    fromMaster(residual);
    step_.current().residual = residual;
    if (state == static_cast<label>(State::accepted))
    {
        step_.accept();
        if (!residual_.isExplicit() && residual >= residual_.tolerance())
        {
            step_.current().converged = false;
        }
        if (solution.balance)
        {
            audit(*solution.balance);
        }
        return;
    }
    nextDisplacement_ = distribute(solution.values);
    step_.current().converged = state == static_cast<label>(State::converged);
}


void Foam::couplingSession::audit
(
    const tokay::channel::InterfaceBalance& balance
)
{
    const scalar depth = interface_.depth();
    conservationAudit::balance structure;
    structure.force = interface_.force(balance.force);
    structure.moment = interface_.moment(balance.moment);
    structure.power = depth*balance.power;
    structure.sweptVolume = depth*balance.sweptVolume;
    audit_.compare(structure);
    audited_ = true;
}


void Foam::couplingSession::requireMotionInLoop()
{
    if (residual_.isExplicit() || pimple_.corr() > 0)
    {
        return;
    }
    structure_.fail
    (
        getEnv("FOAM_EXECUTABLE")
      + " moves the mesh once per time step, before its outer correctors, and "
        "does not read 'moveMeshOuterCorrectors': the mesh cannot follow the "
        "structure within a time step. Use a solver that moves it in each "
        "outer corrector, such as pimpleFoam, rhoPimpleFoam or interFoam, with "
        "a mesh that deforms (no overset mesh); or couple explicitly by "
        "'nOuterCorrectors 1', for a heavy structure"
    );
}


void Foam::couplingSession::requireFollowing()
{
    const string reason(heldPoints_.check(displacement_));
    if (!reason.empty())
    {
        structure_.fail(reason);
    }
}


void Foam::couplingSession::endFinalCorrector()
{
    finalCorrector_.end
    (
        corrector_,
        [this](const bool ifConverged)
        {
            requireFollowing();
            iterate(true, ifConverged);
        }
    );
    if (step_.isAccepted())
    {
        enclosed_.report();
        if (!isAttached_)
        {
            endTimeStep();
        }
    }
}


void Foam::couplingSession::endOuterCorrector()
{
    if (!step_.hasBegun() || corrector_ != pimple_.corr())
    {
        structure_.fail
        (
            "the mesh was not moved in this outer corrector, so the "
            "structure's displacement did not reach the fluid. Check constant/"
            "dynamicMeshDict and 'moveMeshOuterCorrectors yes;'"
        );
    }

    criteria_.update();
    step_.current().outerCorrectors = corrector_;
    step_.current().fluidResidual = criteria_.momentum();

    if (pimple_.finalIter())
    {
        endFinalCorrector();
    }
    else if (step_.hasFailed())
    {
        residual_.endLoop();
    }
    else if (isDue())
    {
        iterate(false, false);
        residual_.enter(step_.current().residual);
        if (step_.hasFailed())
        {
            residual_.endLoop();
        }
    }
    else
    {
        step_.current().converged = false;
        residual_.enter(1);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingSession::couplingSession
(
    const word& name,
    const fvMesh& mesh,
    const dictionary& given
)
:
    displacementSource(registryName(name), mesh),
    mesh_(mesh),
    pimple_(mesh.lookupObject<pimpleControl>("solutionControl")),
    preset_(name, mesh, pimple_, given),
    interface_
    (
        mesh,
        sessionSetup::selectPatches(mesh, preset_.dict()),
        preset_.dict()
    ),
    force_(mesh, preset_.dict()),
    pointDisplacement_
    (
        sessionSetup::findPointDisplacement
        (
            mesh,
            preset_.dict(),
            patches(),
            UName()
        )
    ),
    enclosed_(mesh, preset_.dict(), force_.pName(), force_.UName()),
    heldPoints_(mesh, pointDisplacement_, patches()),
    residual_(name, mesh, pimple_),
    criteria_(name, force_.UName(), mesh, pimple_),
    pressureTolerance_(preset_.dict(), mesh),
    predictor_
    (
        preset_.dict(),
        mesh,
        force_.pName(),
        force_.UName(),
        !residual_.isExplicit()
    ),
    rates_(mesh, force_.UName()),
    interval_(preset_.dict(), residual_, criteria_),
    audit_(mesh, preset_.dict()),
    audited_(false),
    tables_(name, mesh, preset_.dict(), residual_.tolerance()),
    isAttached_(true),
    hasEnded_(false),
    step_(preset_.dict(), mesh, structure_),
    finalCorrector_(mesh.time(), pimple_, residual_, criteria_, step_),
    structure_(preset_.dict(), mesh.time()),
    invertedCells_
    (
        registryName(name) + "InvertedCells",
        mesh,
        [this](const string& cells){ endMeshMotion(cells); }
    ),
    corrector_(0),
    coupledCorrector_(0)
{
    restartFiles::check(mesh, pointDisplacement_, patches(), preset_.dict());
    const tokay::channel::Interface message(describe(name));
    preset_.announce();
    force_.reportAbsolute(patches(), preset_.dict());
    announce();
    startStructure(message);
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::couplingSession::~couplingSession()
{
    if (!isAttached_)
    {
        close();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::vectorField& Foam::couplingSession::displacement
(
    const label patchi
)
{
    requireMotionInLoop();
    if (!step_.hasBegun())
    {
        beginTimeStep();
    }
    else if (corrector_ != pimple_.corr() && !pimple_.finalIter())
    {
        displacement_ = nextDisplacement_;
    }
    // An explicit coupling may have its mesh moved before the loop
    corrector_ = max(pimple_.corr(), label(1));
    step_.current().phases.enter(phaseClock::phase::mesh);
    rates_.keepNew();
    pressureTolerance_.beginCorrector
    (
        residual_.isExplicit() || pimple_.finalIter()
    );

    return displacement_[patches().find(patchi)];
}


void Foam::couplingSession::beginMomentum()
{
    step_.current().phases.enter
    (
        pimple_.momentumPredictor()
      ? phaseClock::phase::momentum
      : phaseClock::phase::pressure
    );
}


void Foam::couplingSession::endVelocityCorrection()
{
    step_.current().phases.enter(phaseClock::phase::coupling);
    const bool isLast = pimple_.corrPISO() == pimple_.nCorrPISO();
    rates_.keepNew();
    if (isLast)
    {
        endOuterCorrector();
    }
    if (pimple_.corrPISO() > 0)
    {
        force_.endPressureCorrector();
    }
    step_.current().phases.enter
    (
        isLast ? phaseClock::phase::other : phaseClock::phase::pressure
    );
}


void Foam::couplingSession::endTimeStep()
{
    if (hasEnded_)
    {
        return;
    }
    hasEnded_ = true;
    tables_.write(step_.end());
    // Only the master has an audit
    if (audited_)
    {
        tables_.write(audit_);
    }
}


void Foam::couplingSession::detach()
{
    if (step_.isAccepted())
    {
        endTimeStep();
    }
    isAttached_ = false;
}


// ************************************************************************* //
