// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    exchangeInterface

Description
    The adapter's side of a coupled run without the flow: sends forces of a
    given pressure to the structure of the case's structureCoupling and receives
    displacements, as its session does. Prints what an exchange takes on the
    master: to gather the forces and to distribute the displacements (wall
    clock, the least of all: other jobs only add to it), and the processor time
    to encode, send, receive, decode and check.

    system/exchangeInterfaceDict:

        nTimeSteps  4;
        nExchanges  4;  // of a time step
        nRepeats    10; // of gather and distribution for each exchange

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "couplingInterface.H"
#include "fvMesh.H"
#include "pointFields.H"
#include "structureConnection.H"
#include "Time.H"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Seconds of each time that something was done
struct secondsOf
{
    std::vector<scalar> gather, distribute, exchange;
};


static scalar wallClock()
{
    return std::chrono::duration<scalar>
    (
        std::chrono::steady_clock::now().time_since_epoch()
    ).count();
}


static scalar processorTime()
{
    return scalar(std::clock())/CLOCKS_PER_SEC;
}


static void awaitAllRanks()
{
    returnReduce(true, andOp<bool>());
}


static scalar least(const std::vector<scalar>& seconds)
{
    return *std::min_element(seconds.begin(), seconds.end());
}


static scalar median(std::vector<scalar> seconds)
{
    const auto middle = seconds.begin() + seconds.size()/2;
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
}


//- Forces of a pressure on the faces of this rank
static vectorField forces
(
    const fvMesh& mesh,
    const labelList& patches,
    const scalar pressure
)
{
    DynamicList<vector> forces;
    for (const label patchi : patches)
    {
        forces.append(pressure*mesh.boundary()[patchi].Sf());
    }
    return vectorField(forces);
}


//- Values of points to their ranks, timed
static void distribute
(
    const couplingInterface& interface,
    const tokay::channel::Displacements& answer,
    std::vector<scalar>& seconds
)
{
    awaitAllRanks();
    const scalar start = wallClock();
    interface.distribute(answer.values);
    seconds.push_back(wallClock() - start);
}


//- An exchange, timed
static void exchange
(
    const couplingInterface& interface,
    structureConnection& structure,
    const vectorField& forces,
    const label nRepeats,
    const bool final,
    secondsOf& seconds
)
{
    tokay::channel::Forces message;
    message.final = final;
    for (label i = 0; i < nRepeats; ++i)
    {
        awaitAllRanks();
        const scalar start = wallClock();
        message.values = interface.collect(forces);
        seconds.gather.push_back(wallClock() - start);
    }
    const scalar start = processorTime();
    const tokay::channel::Displacements answer
    (
        structure.exchange(message, "the structure's displacements")
    );
    seconds.exchange.push_back(processorTime() - start);
    for (label i = 0; i < nRepeats; ++i)
    {
        distribute(interface, answer, seconds.distribute);
    }
}


static void print
(
    const label nFaces,
    const label nOnMaster,
    const scalar nPoints,
    const secondsOf& seconds
)
{
    Info<< "faces " << nFaces
        << " not on the master " << nFaces - nOnMaster
        << " points " << nPoints
        << " gather[s] " << least(seconds.gather)
        << " distribute[s] " << least(seconds.distribute)
        << " exchangeCpu[s] " << median(seconds.exchange) << endl;
}


int main(int argc, char *argv[])
{
    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    runTime.functionObjects().off();
    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );
    const IOdictionary controls
    (
        IOobject
        (
            "exchangeInterfaceDict", runTime.system(), mesh,
            IOobject::MUST_READ
        )
    );
    const label nTimeSteps = controls.get<label>("nTimeSteps");
    const label nExchanges = controls.get<label>("nExchanges");
    const label nRepeats = controls.get<label>("nRepeats");

    const dictionary dict
    (
        runTime.controlDict().subDict("functions").subDict("structure")
    );
    const labelList patches
    (
        mesh.boundaryMesh().patchSet(dict.get<wordRes>("patches")).sortedToc()
    );
    const pointVectorField atRest
    (
        IOobject("atRest", runTime.timeName(), mesh),
        pointMesh::New(mesh),
        dimensionedVector(dimLength, Zero)
    );

    couplingInterface interface(mesh, patches, dict);
    tokay::channel::Interface description;
    description.name = "structure";
    description.tolerance = 1e-4;
    description.deltaT = runTime.deltaTValue();
    description.endTime = nTimeSteps*description.deltaT;
    interface.describe(atRest, description);
    structureConnection structure(dict, runTime);
    structure.start(description);

    secondsOf seconds;
    for (label step = 1; step <= nTimeSteps; ++step)
    {
        tokay::channel::BeginStep begin;
        begin.step = step;
        begin.time = step*description.deltaT;
        begin.deltaT = description.deltaT;
        structure.exchange(begin, "the structure's prediction");
        for (label i = 1; i <= nExchanges; ++i)
        {
            const scalar pressure = 1e-3*step*(1 + 0.5/i);
            exchange
            (
                interface, structure, forces(mesh, patches, pressure),
                nRepeats, i == nExchanges, seconds
            );
        }
    }
    structure.close("the end");
    const label nOnMaster = forces(mesh, patches, 1).size();
    print
    (
        returnReduce(nOnMaster, sumOp<label>()),
        nOnMaster,
        description.points.size()/3,
        seconds
    );
    return 0;
}


// ************************************************************************* //
