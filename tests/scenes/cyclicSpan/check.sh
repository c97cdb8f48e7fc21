#!/usr/bin/env bash
# The perpendicular flap as a slab whose sides are a cyclic pair. Right: the run
# ends, and the tip goes where the plane scene has it (0.0138 m), whether the mesh
# turns with the flap or not.
source "$(dirname "$0")/../scenes.sh"

# expectTip: three digits of it are known
expectTip()
{
    expectClose "tip" "$(watchPoint 0.1)" 0.0138 4e-3
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
    # Points have 12 digits, displacements of 0.01 in coordinates of 4
    expectSameTable "displacement of the sides" 1e-8 back.moved front.moved
}

property still "cyclic sides: the flap's tip with a mesh that does not turn"
still()
{
    makeScene fluid
    entry constant/dynamicMeshDict harmonicBasisCoeffs.rotation no
    runScene
    expectTip
}

runProperties "$@"
