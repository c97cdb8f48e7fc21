// SPDX-License-Identifier: GPL-3.0-or-later
#include "structureCoupling.H"
#include "couplingSession.H"
#include "couplingFvOption.H"
#include "fvOptions.H"
#include "dictionaryChecks.H"
#include "timeControlFunctionObject.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(structureCoupling, 0);

    addToRunTimeSelectionTable
    (
        functionObject,
        structureCoupling,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::couplingSession&
Foam::functionObjects::structureCoupling::session() const
{
    return mesh_.lookupObjectRef<couplingSession>
    (
        couplingSession::registryName(name())
    );
}


void Foam::functionObjects::structureCoupling::writeFileHeader()
{
    Ostream& os = file();
    writeHeader(os, "Coupling of " + name());
    writeCommented(os, "time[s]");
    for
    (
        const char* column
      : {
            "deltaT[s]", "outerCorrectors", "couplingIterations",
            "couplingResidual", "momentumResidual", "converged", "step[s]",
            "force[s]", "structure[s]"
        }
    )
    {
        writeTabbed(os, column);
    }
    os  << endl;
}


void Foam::functionObjects::structureCoupling::writeBalance
(
    const conservationAudit& audit
)
{
    if (!balance_)
    {
        balance_.reset
        (
            new writeFile(mesh_, name(), "conservation", dict_)
        );
        Ostream& os = balance_->file();
        balance_->writeHeader(os, "Both sides of the interface, " + name());
        balance_->writeCommented(os, "time[s]");
        for (const word& column : conservationAudit::columns())
        {
            balance_->writeTabbed(os, column);
        }
        os  << endl;
    }
    Ostream& os = balance_->file();
    balance_->writeCurrentTime(os);
    audit.writeRow(os);
    os  << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::structureCoupling::structureCoupling
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, "coupling", dict),
    dict_(dict)
{
    if (timeControl::entriesPresent(dict))
    {
        FatalIOErrorInFunction(dict)
            << "the coupling acts in every time step: remove the entries that "
            << "control when it executes or writes (timeStart, timeEnd, "
            << "executeControl, writeControl, ...)" << exit(FatalIOError);
    }
    requireKnownEntries
    (
        dict,
        {
            "patches", "rho", "pRef", "viscous", "p", "U", "onUnconverged",
            "retry", "couplingInterval", "pressureTolerance",
            "conservationLimit", "structure",
            // Entries of any function object
            "type", "libs", "functionObjectLibs", "enabled", "log", "region",
            "writePrecision", "writeToFile", "useUserTime"
        }
    );
    if (!mesh_.foundObject<pimpleControl>("solutionControl"))
    {
        FatalIOErrorInFunction(dict)
            << "this solver has no PIMPLE loop to couple in: use one like "
            << "pimpleFoam" << exit(FatalIOError);
    }

    Info<< type() << " " << name << ':' << endl;
    autoPtr<couplingSession> created
    (
        new couplingSession(name, mesh_, dict)
    );
    couplingSession& session = regIOobject::store(created.ptr());

    fv::optionList& options = fv::options::New(mesh_);
    options.append(new fv::couplingFvOption(session, mesh_));

    if (Pstream::master())
    {
        writeFileHeader();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::structureCoupling::read(const dictionary& dict)
{
    IOWarningInFunction(dict)
        << "the coupling runs already: changes of this dictionary take effect "
        << "at the next start" << endl;
    return true;
}


bool Foam::functionObjects::structureCoupling::execute()
{
    const stepController::statistics& step = session().endTimeStep();

    if (Pstream::master())
    {
        Ostream& os = file();
        writeCurrentTime(os);
        os  << tab << step.deltaT << tab << step.outerCorrectors
            << tab << step.couplingIterations << tab << step.residual
            << tab << step.fluidResidual << tab << step.converged
            << tab << step.stepSeconds << tab << step.forceSeconds
            << tab << step.structureSeconds << endl;
    }
    if (const conservationAudit* audit = session().audit())
    {
        writeBalance(*audit);
    }
    return true;
}


bool Foam::functionObjects::structureCoupling::end()
{
    session().close("the fluid's run has ended");
    return true;
}


// ************************************************************************* //
