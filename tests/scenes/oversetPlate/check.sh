#!/usr/bin/env bash
# A solver that moves its mesh once per time step, whatever moveMeshOuterCorrectors says.
# Right: a message that says so, and what can be done.
source "$(dirname "$0")/../scenes.sh"

# makeOverset: the scene with its mesh of two parts
makeOverset()
{
    solver=overPimpleDyMFoam
    makeScene scene
    (cd ../component && blockMesh > log.blockMesh 2>&1) || fail "blockMesh failed"
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    mergeMeshes . ../component -overwrite > log.mergeMeshes 2>&1 || fail "mergeMeshes failed"
    topoSet > log.topoSet 2>&1 || fail "topoSet failed"
    setFields > log.setFields 2>&1 || fail "setFields failed"
}

property once "an overset mesh: a solver that moves it once per time step is named"
once()
{
    makeOverset
    runFaultyFluid
    expectText log.pimpleFoam "overPimpleDyMFoam moves the mesh once per time step, before its outer correctors, and does not read 'moveMeshOuterCorrectors'" \
        "Use a solver that moves it in each outer corrector" "no overset mesh"
    expectNoText log.pimpleFoam "Check constant/dynamicMeshDict"
}

property explicit "an overset mesh: an explicit coupling runs"
explicit()
{
    makeOverset
    entry system/fvSolution PIMPLE.nOuterCorrectors 1
    removeEntry system/fvSolution PIMPLE.residualControl
    entry system/controlDict endTime 0.01
    runFluid
    expectText log.pimpleFoam "explicit coupling, one coupling iteration per time step"
    expectEqual "time steps" "$(grep -vc '^#' postProcessing/structure/0/coupling.dat)" 2
}

runProperties "$@"
