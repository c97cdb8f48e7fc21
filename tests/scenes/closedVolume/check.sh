#!/usr/bin/env bash
# A closed box that is filled through an inlet of given velocity, under an elastic roof.
# The fluid is incompressible, so its volume can only change by that inflow, which
# OpenFOAM finds out in mid-run. Right: told at the start, with what can be done.
source "$(dirname "$0")/../scenes.sh"

property refused "a closed volume: an incompressible fluid under a moving roof is refused at the start"
refused()
{
    makeScene fluid
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    runFaultyFluid
    expectText log.pimpleFoam "the fluid is enclosed: it is incompressible, and no patch fixes the pressure or lets the fluid out: walls (slip), inlet (uniformFixedValue), roof (movingWallVelocity)" \
        "changes the fluid's volume of 1 m3" "use a compressible solver" "'enclosedFluid accept;'" \
        "controlDict.functions.structure"
    expectNoText log.pimpleFoam "Time = "
    [ ! -e ../structure/log.igaStructure ] || fail "the structure was started in vain"
}

property opened "a closed volume: with an opening it is not"
opened()
{
    makeScene fluid
    sed -i 's/walls { type slip; }/walls { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); }/' 0/U
    sed -i 's/pRefCell 0; pRefValue 0;//' system/fvSolution
    sed -i 's/"(inlet|walls|roof)" { type zeroGradient; }/"(inlet|roof)" { type zeroGradient; } walls { type fixedValue; value uniform 0; }/' 0/p
    entry system/controlDict endTime 0.005
    runScene
}

runProperties "$@"
