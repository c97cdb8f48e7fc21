#!/usr/bin/env bash
# The perpendicular flap as a slab whose sides are a cyclic pair. Right: the run
# ends, and the tip goes where the plane scene has it (0.0138 m).
source "$(dirname "$0")/../scenes.sh"

# expectTip: three digits of it are known
expectTip()
{
    expectClose "tip" "$(watchPoint 0.1)" 0.0138 4e-3
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
