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


void Foam::functionObjects::structureCoupling::requireKnown() const
{
    requireKnownEntries
    (
        dict_,
        {
            "patches", "rho", "pRef", "viscous", "p", "U", "preset",
            "onUnconverged", "retry", "couplingInterval", "pressureTolerance",
            "fluidPredictor", "conservationLimit", "enclosedFluid", "structure",
            // Entries of any function object
            "type", "libs", "functionObjectLibs", "enabled", "errors", "log",
            "region", "writePrecision", "writeToFile", "updateHeader",
            "useUserTime"
        }
    );
}


void Foam::functionObjects::structureCoupling::start()
{
    Info<< type() << " " << name() << ':' << endl;
    autoPtr<couplingSession> created
    (
        new couplingSession(name(), mesh_, dict_)
    );
    couplingSession& session = regIOobject::store(created.ptr());

    fv::optionList& options = fv::options::New(mesh_);
    options.append(new fv::couplingFvOption(session, mesh_));
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
    dict_(dict),
    regionName_(mesh_.name()),
    hasEnded_(false)
{
    if (timeControl::entriesPresent(dict))
    {
        FatalIOErrorInFunction(dict)
            << "the coupling acts in every time step: remove the entries that "
            << "control when it executes or writes (timeStart, timeEnd, "
            << "executeControl, writeControl, ...)" << exit(FatalIOError);
    }
    requireKnown();
    if (!mesh_.foundObject<pimpleControl>("solutionControl"))
    {
        FatalIOErrorInFunction(dict)
            << "this solver has no PIMPLE loop to couple in: use one like "
            << "pimpleFoam" << exit(FatalIOError);
    }
    if (mesh_.foundObject<couplingSession>(couplingSession::registryName(name)))
    {
        Info<< type() << " " << name << ": the coupling runs already; changes "
            << "of its dictionary take effect at the next start" << endl;
        session().attach();
        return;
    }
    start();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::functionObjects::structureCoupling::~structureCoupling()
{
    // At the end of the program the mesh goes first
    if (hasEnded_ || !time_.foundObject<fvMesh>(regionName_))
    {
        return;
    }
    const word sessionName(couplingSession::registryName(name()));
    if (mesh_.foundObject<couplingSession>(sessionName))
    {
        WarningInFunction
            << "the function object '" << name() << "' was disabled or removed "
            << "while the coupling runs: the coupling goes on as it was, with "
            << "its tables, until the end of the run" << nl
            << "    to end it, stop the run by 'stopAt writeNow'" << endl;
        session().detach();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::structureCoupling::read(const dictionary& dict)
{
    string changed;
    for (const entry& e : dict)
    {
        const entry* const before =
            dict_.findEntry(e.keyword(), keyType::LITERAL);
        if (!before || *before != e)
        {
            changed += ' ' + e.keyword();
        }
    }
    for (const entry& e : dict_)
    {
        if (!dict.found(e.keyword(), keyType::LITERAL))
        {
            changed += ' ' + e.keyword();
        }
    }
    IOWarningInFunction(dict)
        << "the coupling runs already; changes take effect at the next start:"
        << changed.c_str() << endl;
    dict_ = dict;
    return true;
}


bool Foam::functionObjects::structureCoupling::execute()
{
    session().endTimeStep();
    return true;
}


bool Foam::functionObjects::structureCoupling::end()
{
    hasEnded_ = true;
    session().close();
    return true;
}


// ************************************************************************* //
