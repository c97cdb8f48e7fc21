#!/usr/bin/env bash
# A mesh with cells turned inside out ends the step before the flow is solved for on
# it, whatever has moved it. (That the step can be repeated is in testRetry.sh.)
source "$(dirname "$0")/harness.sh"

# makeLeap FOLDER: the flap is displaced by more than its height in one step
makeLeap()
{
    makeCase "$1"
    behave leaps
}

# expectNamed: cells and what to do about them, and no floating point exception
expectNamed()
{
    expectText log.pimpleFoam "the mesh motion leaves" "cells without a positive volume at time 0.01 s: cell" \
        "m^3; cell" "Reduce deltaT" "'onUnconverged retry'"
    expectNoText log.pimpleFoam "sigFpe"
}

property harmonicBasis "inverted cells: harmonicBasis"
harmonicBasis()
{
    makeLeap fluid
    runFaultyFluid
    expectNamed
}

property laplacian "inverted cells: displacementLaplacian"
laplacian()
{
    makeLeap fluid
    useLaplacian
    runFaultyFluid
    expectNamed
}

property warn "inverted cells: not accepted by 'onUnconverged warn' either"
warn()
{
    makeLeap fluid
    coupling onUnconverged warn
    runFaultyFluid
    expectNamed
}

property parallel "inverted cells: on two ranks, with the rank's number"
parallel()
{
    makeLeap fluid
    decompose 2
    runFaultyFluid 2
    expectNamed
    expectText log.pimpleFoam "of processor 1 at"
}

runProperties "$@"
