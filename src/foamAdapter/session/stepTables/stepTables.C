// SPDX-License-Identifier: GPL-3.0-or-later
#include "stepTables.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Columns of coupling.dat besides the time
Foam::wordList couplingColumns()
{
    Foam::wordList columns
    ({
        "deltaT[s]", "outerCorrectors", "couplingIterations",
        "couplingResidual", "momentumResidual", "converged", "step[s]",
        "force[s]", "structure[s]"
    });
    columns.append(Foam::phaseClock::columns());
    columns.append("gather[s]");
    return columns;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::stepTables::table::table
(
    const word& couplingName,
    const word& fileName,
    const fvMesh& mesh,
    const dictionary& dict,
    const string& title,
    const wordList& columns
)
:
    writeFile(mesh, couplingName, fileName, dict)
{
    if (!Pstream::master())
    {
        return;
    }
    Ostream& os = file();
    writeHeader(os, title);
    writeCommented(os, "time[s]");
    for (const word& column : columns)
    {
        writeTabbed(os, column);
    }
    os  << endl;
}


Foam::Ostream& Foam::stepTables::table::beginRow()
{
    Ostream& os = file();
    writeCurrentTime(os);
    return os;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepTables::stepTables
(
    const word& name,
    const fvMesh& mesh,
    const dictionary& dict,
    const scalar tolerance
)
:
    name_(name),
    mesh_(mesh),
    dict_(dict),
    coupling_
    (
        name,
        "coupling",
        mesh,
        dict,
        "Coupling of " + name + ", tolerance " + Foam::name(tolerance),
        couplingColumns()
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepTables::write(const stepController::statistics& step)
{
    if (!Pstream::master())
    {
        return;
    }
    Ostream& os = coupling_.beginRow();
    os  << tab << step.deltaT << tab << step.outerCorrectors
        << tab << step.couplingIterations << tab << step.residual
        << tab << step.fluidResidual << tab << step.converged
        << tab << step.stepSeconds << tab << step.forceSeconds
        << tab << step.structureSeconds;
    for (const scalar seconds : step.phases.seconds())
    {
        os  << tab << seconds;
    }
    os  << tab << step.gatherSeconds << endl;
}


void Foam::stepTables::write(const conservationAudit& audit)
{
    if (!conservation_.valid())
    {
        conservation_.reset
        (
            new table
            (
                name_,
                "conservation",
                mesh_,
                dict_,
                "Both sides of the interface, " + name_,
                conservationAudit::columns()
            )
        );
    }
    Ostream& os = conservation_->beginRow();
    audit.writeRow(os);
    os  << endl;
}


// ************************************************************************* //
