// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingSession.H"
#include "structureDisplacementPointPatchVectorField.H"
#include "movingWallVelocityFvPatchVectorField.H"
#include "Time.H"

#include <chrono>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(couplingSession, 0);
}

const Foam::Enum<Foam::couplingSession::unconverged>
Foam::couplingSession::unconvergedNames
({
    {unconverged::abort, "abort"},
    {unconverged::warn, "warn"},
    {unconverged::retry, "retry"}
});

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Wall clock [s]
double wallClock()
{
    return std::chrono::duration<double>
    (
        std::chrono::steady_clock::now().time_since_epoch()
    ).count();
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::couplingSession::selectPatches
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const wordRes names(dict.get<wordRes>("patches"));
    const polyBoundaryMesh& boundary = mesh.boundaryMesh();

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


const Foam::pointVectorField&
Foam::couplingSession::findPointDisplacement() const
{
    if (!mesh_.foundObject<pointVectorField>("pointDisplacement"))
    {
        FatalIOErrorInFunction(dict_)
            << "no field 'pointDisplacement': the mesh does not move by "
            << "displacement" << nl
            << "    use a displacement motion solver, such as "
            << "displacementLaplacian, in constant/dynamicMeshDict"
            << exit(FatalIOError);
    }
    const pointVectorField& displacement =
        mesh_.lookupObject<pointVectorField>("pointDisplacement");
    const volVectorField& U =
        mesh_.lookupObject<volVectorField>(force_.UName());

    for (const label patchi : interface_.patches())
    {
        const word& patchName = mesh_.boundary()[patchi].name();
        const auto& condition = displacement.boundaryField()[patchi];
        if (!isA<structureDisplacementPointPatchVectorField>(condition))
        {
            FatalIOErrorInFunction(dict_)
                << "pointDisplacement has '" << condition.type()
                << "' on the coupled patch '" << patchName << "'" << nl
                << "    it must be '"
                << structureDisplacementPointPatchVectorField::typeName
                << "'" << exit(FatalIOError);
        }
        if
        (
            !isA<movingWallVelocityFvPatchVectorField>
            (
                U.boundaryField()[patchi]
            )
        )
        {
            IOWarningInFunction(dict_)
                << force_.UName() << " has '"
                << U.boundaryField()[patchi].type()
                << "' on the coupled patch '" << patchName
                << "': a wall that moves with the structure has "
                << "'movingWallVelocity'" << endl;
        }
    }
    return displacement;
}


void Foam::couplingSession::beginTimeStep()
{
    const Time& runTime = mesh_.time();

    stepStart_ = wallClock();
    current_ = statistics();
    current_.deltaT = runTime.deltaTValue();
    accepted_ = false;
    audited_ = false;
    failure_.clear();
    if (retry_.valid())
    {
        retry_->beginTimeStep();
    }
    rates_.beginTimeStep();
    exchangeCorrector_ = 0;
    timeIndex_ = runTime.timeIndex();

    tokay::channel::BeginStep message;
    message.step = timeIndex_ - runTime.startTimeIndex();
    message.time = runTime.value();
    message.deltaT = runTime.deltaTValue();

    const tokay::channel::Displacements answer
    (
        structure_.exchange
        (
            message,
            "the structure's predicted displacements, step "
          + std::to_string(message.step)
        )
    );
    displacement_ = interface_.distribute(answer.values);
    nextDisplacement_ = displacement_;
    current_.exchangeSeconds += wallClock() - stepStart_;
}


void Foam::couplingSession::checkForces(const vectorField& forces)
{
    string error;
    label facei = 0;
    for (const label patchi : interface_.patches())
    {
        for (const point& centre : mesh_.boundary()[patchi].Cf())
        {
            const vector& force = forces[facei++];
            if (error.empty() && !std::isfinite(force.x() + force.y() + force.z()))
            {
                OStringStream os;
                os  << "the fluid's force is not finite: " << force
                    << " N on patch '" << mesh_.boundary()[patchi].name()
                    << "' at " << centre << ", time "
                    << mesh_.time().timeName()
                    << " s. The flow has diverged";
                error = os.str();
            }
        }
    }

    // One of the ranks' messages, known to all
    List<string> errors(Pstream::nProcs());
    errors[Pstream::myProcNo()] = error;
    Pstream::gatherList(errors);
    Pstream::scatterList(errors);
    for (const string& text : errors)
    {
        if (!text.empty() && !retry_.valid())
        {
            structure_.fail(text + ": reduce deltaT, or check the mesh near "
                "that place");
        }
        if (failure_.empty())
        {
            failure_ = text;
        }
    }
}


bool Foam::couplingSession::exchangeIsDue() const
{
    return policy_.isDue(corrector_ - exchangeCorrector_)
        || corrector_ == pimple_.nCorrPIMPLE() - 1;
}


void Foam::couplingSession::exchange(const bool final)
{
    const scalar start = wallClock();
    const vectorField forces(force_(interface_.patches()));
    checkForces(forces);
    if (!failure_.empty())
    {
        return;
    }
    if (final && audit_.active())
    {
        audit_.measure(interface_, forces);
    }

    tokay::channel::Forces message;
    message.final = final;
    message.write = final && mesh_.time().writeTime();
    message.fluidResidual = current_.fluidResidual;
    message.values = interface_.collect(forces);
    const scalar sent = wallClock();

    const tokay::channel::Displacements answer
    (
        structure_.exchange
        (
            message,
            "the structure's displacements, step "
          + std::to_string(timeIndex_ - mesh_.time().startTimeIndex())
          + ", corrector " + std::to_string(corrector_)
        )
    );
    failure_ = answer.reason;
    Pstream::scatter(failure_);
    if (!final && failure_.empty())
    {
        nextDisplacement_ = interface_.distribute(answer.values);

        scalarList state(2);
        state[0] = answer.residual;
        state[1] = answer.state != tokay::channel::State::iterate;
        Pstream::scatter(state);
        current_.residual = state[0];
        current_.converged = state[1] > 0;
    }
    else if (answer.balance)
    {
        audit(*answer.balance);
    }
    exchangeCorrector_ = corrector_;
    ++current_.exchanges;
    current_.forceSeconds += sent - start;
    current_.exchangeSeconds += wallClock() - sent;
}


void Foam::couplingSession::audit
(
    const tokay::channel::InterfaceBalance& answer
)
{
    const scalar depth = interface_.depth();
    conservationAudit::balance structure;
    structure.force = interface_.force(answer.force);
    structure.moment = interface_.moment(answer.moment);
    structure.power = depth*answer.power;
    structure.sweptVolume = depth*answer.sweptVolume;
    audit_.compare(structure);
    audited_ = true;
}


Foam::string Foam::couplingSession::describeUnconverged() const
{
    OStringStream os;
    os  << "time " << mesh_.time().timeName() << " s did not converge in "
        << pimple_.nCorrPIMPLE() << " correctors: coupling residual "
        << current_.residual << " (tolerance " << residual_.tolerance()
        << "), momentum residual " << current_.fluidResidual;
    return os.str();
}


bool Foam::couplingSession::ranOut() const
{
    return
        !residual_.isExplicit()
     && corrector_ == pimple_.nCorrPIMPLE()
     && !(current_.converged && residual_.momentumConverged());
}


void Foam::couplingSession::endLastCorrector()
{
    if (failure_.empty() && ranOut())
    {
        const string text(describeUnconverged());
        switch (onUnconverged_)
        {
            case unconverged::abort:
                structure_.fail
                (
                    text + ". Raise nOuterCorrectors, reduce deltaT, choose "
                    "another acceleration in the structure's case file, let "
                    "such steps be repeated by 'onUnconverged retry', or "
                    "accept them by 'onUnconverged warn'"
                );
                break;

            case unconverged::warn:
                WarningInFunction << text.c_str() << nl
                    << "    accepted all the same, by 'onUnconverged warn'"
                    << endl;
                break;

            case unconverged::retry:
                failure_ = text;
                break;
        }
    }
    if (failure_.empty())
    {
        exchange(true);
    }
    if (!failure_.empty())
    {
        reject();
        return;
    }
    accepted_ = true;
}


void Foam::couplingSession::reject()
{
    if (!retry_->isPossible())
    {
        OStringStream os;
        os  << ". A step of half of " << mesh_.time().deltaTValue()
            << " s would be below 'smallestDeltaT' " << retry_->smallestDeltaT()
            << " s of 'retry': lower it, or look for what is wrong";
        structure_.fail(failure_ + os.str());
    }
    const word time(mesh_.time().timeName());
    structure_.reject(failure_);
    const scalar deltaT = retry_->rejectTimeStep();
    timeIndex_ = -1;
    Info<< "structureCoupling: the step to " << time << " s is taken back: "
        << failure_.c_str() << nl
        << "    it is repeated with deltaT " << deltaT << " s" << nl << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingSession::couplingSession
(
    const word& name,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    regIOobject
    (
        IOobject
        (
            registryName(name),
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    dict_(dict),
    pimple_(mesh.lookupObject<pimpleControl>("solutionControl")),
    onUnconverged_
    (
        unconvergedNames.getOrDefault
        (
            "onUnconverged", dict, unconverged::abort
        )
    ),
    retry_
    (
        onUnconverged_ == unconverged::retry
      ? new stepRetry(dict, mesh)
      : nullptr
    ),
    interface_(mesh, selectPatches(mesh, dict), dict),
    force_(mesh, dict),
    residual_(name, force_.UName(), mesh, pimple_),
    innerTolerances_(dict, mesh),
    rates_(mesh, force_.UName()),
    policy_(dict, residual_),
    audit_(mesh, dict),
    audited_(false),
    pointDisplacement_(findPointDisplacement()),
    structure_(dict, mesh.time()),
    timeIndex_(-1),
    corrector_(0),
    exchangeCorrector_(0),
    accepted_(false),
    stepStart_(0)
{
    tokay::channel::Interface message;
    message.name = name;
    message.tolerance = residual_.tolerance();
    message.audit = audit_.active();
    message.startTime = mesh.time().startTime().value();
    message.endTime = mesh.time().endTime().value();
    message.deltaT = mesh.time().deltaTValue();
    message.retries = retry_.valid();
    interface_.describe(pointDisplacement_, message);

    if (residual_.isExplicit())
    {
        Info<< "    explicit coupling, one exchange a step" << endl;
    }
    else
    {
        Info<< "    strong coupling, tolerance " << residual_.tolerance()
            << endl;
        innerTolerances_.announce();
    }
    Info<< structure_.start(message).c_str() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::couplingSession* Foam::couplingSession::find
(
    const fvMesh& mesh,
    const label patchi
)
{
    for (const word& name : mesh.sortedNames<couplingSession>())
    {
        couplingSession& session = mesh.lookupObjectRef<couplingSession>(name);
        if (session.interface_.patches().found(patchi))
        {
            return &session;
        }
    }
    return nullptr;
}


const Foam::vectorField& Foam::couplingSession::displacement
(
    const label patchi
)
{
    if (timeIndex_ != mesh_.time().timeIndex())
    {
        beginTimeStep();
    }
    else if (corrector_ != pimple_.corr() && !pimple_.finalIter())
    {
        displacement_ = nextDisplacement_;
    }
    corrector_ = pimple_.corr();
    rates_.keepNew();
    innerTolerances_.beginCorrector(pimple_.finalIter());

    return displacement_[interface_.patches().find(patchi)];
}


void Foam::couplingSession::endCorrector()
{
    if
    (
        timeIndex_ != mesh_.time().timeIndex()
     || corrector_ != pimple_.corr()
    )
    {
        structure_.fail
        (
            "the mesh was not moved in this corrector, so the structure's "
            "displacement did not reach the fluid. Check constant/"
            "dynamicMeshDict and 'moveMeshOuterCorrectors yes;'"
        );
    }

    current_.correctors = corrector_;
    current_.fluidResidual = residual_.momentum();

    if (pimple_.finalIter())
    {
        endLastCorrector();
    }
    else if (exchangeIsDue())
    {
        exchange(false);
        residual_.enter(current_.residual);
        if (!failure_.empty())
        {
            residual_.endLoop();
        }
    }
    else
    {
        current_.converged = false;
        residual_.enter(1);
    }
}


Foam::couplingSession::statistics Foam::couplingSession::endTimeStep()
{
    if (!accepted_)
    {
        structure_.fail
        (
            "the time step has ended without its final corrector, so the "
            "structure has not accepted it: is 'solveFlow' on?"
        );
    }
    current_.stepSeconds = wallClock() - stepStart_;
    if (retry_.valid())
    {
        retry_->endTimeStep();
    }
    return current_;
}


void Foam::couplingSession::close(const string& reason)
{
    structure_.close(reason);
}


// ************************************************************************* //
