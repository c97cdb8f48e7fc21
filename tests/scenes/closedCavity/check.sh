#!/usr/bin/env bash
# A cavity with an elastic floor and no opening. Today's OpenFOAM changes the volume of
# the incompressible fluid without a word. Right: refused, or accepted by the case, and
# then the change of volume is reported.
source "$(dirname "$0")/../scenes.sh"

property accepted "a closed cavity: the case can accept it, and the change of volume is reported"
accepted()
{
    makeScene fluid
    coupling enclosedFluid accept
    entry system/controlDict endTime 0.5
    entry system/controlDict writeInterval 0.5
    runScene
    expectText log.pimpleFoam "the fluid is enclosed, as accepted by 'enclosedFluid accept': volume 1 m3"
    # The mesh's volume by its points: the floor's edge, of unit depth
    local change
    change=$(sed -n 's/.*volume of the enclosed fluid has changed by \(.*\) m3 since the start.*/\1/p' log.pimpleFoam)
    conservation=postProcessing/structure/0/conservation.dat
    column=$(grep '^# time' $conservation | tr '\t' '\n' | sed 's/^ *//; s/ *$//' | grep -n 'fluidSweptVolume' | cut -d : -f 1)
    grep -v '^#' $conservation | awk -F '\t' -v c="$column" '{ sum += $c } END { printf "%.12g\n", sum }' > swept
    # What the walls have swept out of the fluid is what it has gained; six digits each
    expectClose "change of volume" "$change" "$(cat swept)" 1e-4
}

property refused "a closed cavity: refused unless the case accepts it"
refused()
{
    makeScene fluid
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    runFaultyFluid
    expectText log.pimpleFoam "the fluid is enclosed" "floor (movingWallVelocity), lid (exprFixedValue), walls (noSlip)"
}

runProperties "$@"
