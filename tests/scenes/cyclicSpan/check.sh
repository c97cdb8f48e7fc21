#!/usr/bin/env bash
# The perpendicular flap as a slab whose sides are a cyclic pair. Right: the run
# ends, and the tip goes where the plane scene has it (0.0134 m; with loads: transposed, as
# point loads on its coarse faces, 0.0138 m), whether the mesh
# turns with the flap or not. Nothing flows across, and what is left there of the linear
# solvers keeps no step from converging, though residualControl has U.
source "$(dirname "$0")/../scenes.sh"

# expectTip: three digits of it are known
expectTip()
{
    expectClose "tip" "$(watchPoint 0.1)" 0.0134 4e-3
}

property turns "cyclic sides: the flap's tip with a mesh that turns with the flap"
turns()
{
    makeScene fluid
    runScene
    expectTip
    # Sides at z 0 and 1, of the same points
    movedPoints constant/polyMesh/points 0.1/polyMesh/points > moved
    awk '$3 == 0 { print $1, $2, $4, $5 }' moved | sort > back
    awk '$3 == 1 { print $1, $2, $4, $5 }' moved | sort > front
    cut -d ' ' -f 3- back > back.moved
    cut -d ' ' -f 3- front > front.moved
    # The flap follows what the linear solvers leave of the pressure across; the points'
    # 12 digits are 4e-10 of its displacement
    expectSameTable "displacement of the sides" 1e-7 back.moved front.moved
}

property still "cyclic sides: the flap's tip with a mesh that does not turn"
still()
{
    makeScene fluid
    entry constant/dynamicMeshDict harmonicBasisCoeffs.rotation no
    runScene
    expectTip
    expectText log.pimpleFoam "nothing flows along z: Uz is at most"
}

property crossFlow "cyclic sides: a flow across that is small but no noise counts, and is named"
crossFlow()
{
    makeScene fluid
    # A thousandth of the velocity
    sed -i 's/uniform (10 0 0)/uniform (10 0 0.01)/' 0/U
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-9
    entry system/fvSolution PIMPLE.nOuterCorrectors 3
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    runFaultyFluid
    expectNoText log.pimpleFoam "nothing flows along"
    expectText log.pimpleFoam "above the tolerance of residualControl: " "Uz "
}

runProperties "$@"
