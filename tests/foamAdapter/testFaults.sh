#!/usr/bin/env bash
# Whatever goes wrong in a run, both sides end in time, not with status 0, and say
# why; no process is left.
source "$(dirname "$0")/harness.sh"

# misbehave BEHAVIOUR TEXT...: the fluid says this of such a structure
misbehave()
{
    makeCase fluid
    behave "$1"
    runFaultyFluid
    shift
    expectText log.pimpleFoam "$@"
}

# What the structure says of the fluid's end
expectStructureSays()
{
    expectText log.igaStructure "$@"
}

# startLongRun [RANKS]: a run without an end, three steps old
startLongRun()
{
    makeCase fluid
    entry system/controlDict endTime 1000
    entry system/controlDict writeInterval 1000
    if [ "${1:-1}" -gt 1 ]
    then
        decompose "$1"
    fi
    startFluid "$@"
    waitForText record "step 3"
    startTime=$SECONDS
}

property version "another version of the messages is refused by both sides"
version()
{
    misbehave otherVersion "ended: protocol version 5 of Tokay" \
        "fakeStructure speaks version 6: install the same Tokay on both sides" \
        "the structure ended with status 2; its log:" "log.igaStructure"
    expectStructureSays "protocol version 5 of Tokay"
}

property refusal "a structure that refuses the interface is quoted"
refusal()
{
    misbehave refuse "the structure ended: this interface is not mine" "ended with status 1"
}

property garbage "bytes that are no message end the run"
garbage()
{
    misbehave garbage "from the structure: what arrived is not a message of Tokay"
}

property truncated "a message that is cut off ends the run"
truncated()
{
    misbehave truncated "the structure ended without saying why, while this side waited for the structure's displacements, step 1, outer corrector 1"
}

property oversized "a message that claims an absurd length ends the run"
oversized()
{
    misbehave oversized "from the structure: " "4294967295"
}

property structureNan "a displacement that is not a number ends the run on both sides"
structureNan()
{
    misbehave nan "the structure's displacement is not finite, component 29 of 30"
    expectStructureSays "the fluid ended: the structure's displacement is not finite"
}

property tooFew "a message with too few displacements ends the run on both sides"
tooFew()
{
    misbehave tooFew "the structure sent 29 displacement components where the interface has 30"
    expectStructureSays "the fluid ended: the structure sent 29 displacement components"
}

# lies BEHAVIOUR TEXT: such an answer ends the run on both sides
lies()
{
    misbehave "$1" "$2"
    expectStructureSays "the fluid ended: $2"
}

property convergedFar "a structure that says converged with a residual of 1e5 is not believed"
convergedFar()
{
    lies convergedFar "the structure says that the step has converged, with a coupling residual of 100000"
}

property residualNan "a coupling residual that is not a number ends the run on both sides"
residualNan()
{
    lies residualNan "the structure's coupling residual is nan"
}

property acceptsEarly "a structure that accepts before the final corrector ends the run on both sides"
acceptsEarly()
{
    lies acceptsEarly "the structure answered 'accepted' to forces"
}

property rejectsPrediction "a rejection in place of a prediction ends the run on both sides"
rejectsPrediction()
{
    lies rejectsPrediction "the structure answered 'rejected' to the begin of a time step"
}

property rejectsSilently "a rejection without a reason ends the run in order"
rejectsSilently()
{
    misbehave rejectsSilently "the structure has no solution, and gives no reason"
}

property escapes "no control character of the structure's texts reaches the terminal"
escapes()
{
    makeCase fluid
    behave escapes
    runFluid
    expectText log.pimpleFoam "fakeStructure, escapes?[2J?"
    expectNoText log.pimpleFoam $'\x1b'
}

property fluidNan "a force that is not a number ends the run on both sides"
fluidNan()
{
    makeCase fluid
    overflow
    runFaultyFluid
    expectText log.pimpleFoam "the fluid's force is not finite" "on patch 'flap' at (" "time 0.01 s" "reduce deltaT"
    expectStructureSays "the fluid ended: the fluid's force is not finite"
}

# Forces beyond all numbers, of a flow that is in order, where nothing traps them
overflow()
{
    coupling rho 9e299
    entry 0/p boundaryField.outlet.value 'uniform 1e12'
    export FOAM_SIGFPE=false
}

property floatingPoint "a floating point exception of the fluid is explained on both sides"
floatingPoint()
{
    makeCase fluid
    diverge
    startFluid
    expectBadEnd
    expectText log.pimpleFoam "structureCoupling: the run ends here: it was stopped by a floating point exception (SIGFPE)" \
        "reduce deltaT"
    expectStructureSays "the fluid ended: it was stopped by a floating point exception (SIGFPE)"
}

# The inlet's velocity overflows in the second step
diverge()
{
    entry 0/U boundaryField.inlet \
        '{ type uniformFixedValue; uniformValue table ((0 (10 0 0)) (0.015 (10 0 0)) (0.02 (1e200 0 0))); }'
}

property structureDies "a structure that dies in mid-run is reported with its signal and its log"
structureDies()
{
    startLongRun
    kill -KILL "$(processOf fakeStructure)"
    expectBadEnd
    expectOneMessage
    expectText log.pimpleFoam "the structure ended without saying why" \
        "the structure was ended by signal 9 (Killed); its log:" "log.igaStructure"
}

property fluidDies "a structure whose fluid dies in mid-run ends, and says so"
fluidDies()
{
    startLongRun
    kill -KILL "$fluid"
    expectBadEnd
    expectStructureSays "the fluid ended without saying why"
}

property interruption "Ctrl-C ends both sides, and the fluid says so"
interruption()
{
    startLongRun
    kill -INT -- "-$fluid"
    expectBadEnd
    expectText log.pimpleFoam "structureCoupling: the run ends here: it was interrupted (SIGINT, Ctrl-C)"
}

property fluidInterrupted "a structure hears that only the fluid was interrupted"
fluidInterrupted()
{
    startLongRun
    kill -INT "$fluid"
    expectBadEnd
    expectStructureSays "the fluid ended: it was interrupted (SIGINT, Ctrl-C)"
}

property termination "a terminated fluid says so on both sides"
termination()
{
    startLongRun
    kill -TERM "$fluid"
    expectBadEnd
    expectText log.pimpleFoam "structureCoupling: the run ends here: it was terminated (SIGTERM)"
    expectStructureSays "the fluid ended: it was terminated (SIGTERM)"
}

property failsAtEnd "a structure that fails after the goodbye fails the run"
failsAtEnd()
{
    misbehave failsAtEnd "the structure ended with status 3; its log:"
    expectEqual "rows" "$(grep -vc '^#' postProcessing/structure/0/coupling.dat)" 3
}

property silent "a structure that is silent is reported, and the run goes on"
silent()
{
    makeCase fluid
    behave silent
    coupling structure.silenceInterval 1
    entry system/controlDict endTime 0.02
    runFluid
    expectText log.pimpleFoam "structureCoupling: waiting for the structure's displacements since 1 s, step 1, outer corrector 1"
}

property otherFault "a structure hears that the fluid has stopped for a reason of its own"
otherFault()
{
    makeCase fluid
    # Missed in the first final corrector
    removeEntry system/fvSolution solvers.pFinal
    runFaultyFluid
    expectText log.pimpleFoam "pFinal"
    expectStructureSays "the fluid ended: it was stopped by an error of its own. See its log"
}

property abortion "a structure hears that the fluid has aborted"
abortion()
{
    startLongRun
    kill -ABRT "$fluid"
    expectBadEnd
    expectStructureSays "the fluid ended: it was stopped by an error of its own. See its log"
}

property parallelStructureDies "in parallel all ranks end with a structure that dies, with one message"
parallelStructureDies()
{
    startLongRun 2
    kill -KILL "$(processOf fakeStructure)"
    expectBadEnd
    expectOneMessage
    expectText log.pimpleFoam "the structure was ended by signal 9 (Killed); its log:"
}

property parallelRankDies "in parallel the structure and all ranks end with a rank that dies"
parallelRankDies()
{
    startLongRun 2
    kill -KILL "$(processOf pimpleFoam)"
    expectBadEnd
}

property parallelInterruption "in parallel Ctrl-C ends everything, and the fluid says so once"
parallelInterruption()
{
    startLongRun 2
    kill -INT -- "-$fluid"
    expectBadEnd
    expectEqual "notices" "$(grep -c 'structureCoupling: the run ends here: it was' log.pimpleFoam)" 1
}

property parallelFloatingPoint "in parallel a floating point exception ends everything, and is explained"
parallelFloatingPoint()
{
    makeCase fluid
    diverge
    decompose 2
    # OpenFOAM prints its stack by other programs: slow on a busy machine
    faultLimit=30
    startFluid 2
    expectBadEnd
    expectText log.pimpleFoam "it was stopped by a floating point exception (SIGFPE)" "reduce deltaT"
}

property parallelNan "in parallel a force that is not a number on one rank ends all, with one message"
parallelNan()
{
    makeCase fluid
    overflow
    decompose 2
    runFaultyFluid 2
    expectOneMessage
    expectText log.pimpleFoam "the fluid's force is not finite"
    expectStructureSays "the fluid ended: the fluid's force is not finite"
}

runProperties "$@"
