#!/usr/bin/env bash
# A run that stops and goes on gives the history of one that did not stop.
source "$(dirname "$0")/harness.sh"

# tipFrom FOLDER START: "time ux uy" of the tip, of the table that begins then
tipFrom()
{
    grep -v '^#' "$1/structure/postProcessing/flap/$2/watchPoints.dat"
}

# correctorsFrom FOLDER START: of each step, of the table that begins then
correctorsFrom()
{
    awk '!/^#/ && $1 > 0.0501 { print $3 }' "$1/postProcessing/structure/$2/coupling.dat" | tr '\n' ' '
}

# makeFluid FOLDER: a flap that moves by millimetres a step, ten steps, with the
# files that an exact restart needs
makeFluid()
{
    makeFlap "$1"
    entry system/controlDict endTime 0.1
    entry system/controlDict writeInterval 0.05
    entry system/controlDict writeFormat binary
    flapEntry 4e6 1e6
}

# stopAndCopy: leaves, in a copy named continued, what a run has that was stopped
# after 0.05 s
stopAndCopy()
{
    cd "$propertyFolder"
    cp -r whole continued
    cd continued
    rm -rf 0.1 processor*/0.1 structure/results/states/flap_0.1.state
    entry system/controlDict startFrom latestTime
}

# goOn [RANKS]
goOn()
{
    runFluid "$@"
    expectText log.igaStructure "restarting from the saved state at t = 0.05 s"
}

# expectSameHistory TOLERANCE: both runs, from 0.05 s on
expectSameHistory()
{
    cd "$propertyFolder"
    tipFrom whole 0 | awk '$1 > 0.0501' > whole.tip
    tipFrom continued 0.05 > continued.tip
    expectEqual "steps" "$(wc -l < continued.tip)" 5
    expectSameTable "tip" "$1" whole.tip continued.tip
}

# expectExact [RANKS]: the run goes on as if it had not stopped
expectExact()
{
    runFluid "$@"
    stopAndCopy
    goOn "$@"
    # The table has twelve digits
    expectSameHistory 1e-12
    expectEqual "correctors" "$(correctorsFrom continued 0.05)" "$(correctorsFrom whole 0)"
}

property exact "a run goes on from its written time digit by digit as if it had not stopped"
exact()
{
    makeFluid whole
    expectExact
    expectEqual "times of the structure's results" \
        "$(sed -n 's/.*timestep="\([^"]*\)".*/\1/p' continued/structure/results/flap.pvd | tr '\n' ' ')" "0 0.05 0.1 "
    [ -s continued/structure/postProcessing/flap/0/watchPoints.dat ] || fail "the earlier table is lost"
}

property nonlinear "a nonlinear structure with the multi-vector method goes on digit by digit"
nonlinear()
{
    makeFluid whole
    flapEntry "strains: linear" "strains: nonlinear"
    flapEntry "predictor: quadratic" "acceleration: {type: mvqn}"
    expectExact
}

property preset "so does a run whose entries a preset sets on both sides"
preset()
{
    makeFluid whole
    removeEntry system/fvSolution PIMPLE.residualControl
    coupling preset reference
    flapEntry "predictor: quadratic" "preset: reference"
    expectExact
    expectText whole/log.pimpleFoam "preset reference sets residualControl.structure.tolerance"
    expectText continued/log.pimpleFoam "preset reference sets residualControl.structure.tolerance"
}

property laplacian "so does a mesh that OpenFOAM's displacementLaplacian moves"
laplacian()
{
    makeFluid whole
    useLaplacian
    expectExact
}

property doubled "so does harmonicBasis after it has doubled its functions"
doubled()
{
    makeFluid whole
    entry constant/dynamicMeshDict harmonicBasisCoeffs.nFunctions 2
    entry constant/dynamicMeshDict harmonicBasisCoeffs.fitLimit 3e-3
    expectExact
    [ "$(grep -c 'harmonicBasis: .* functions' whole/log.pimpleFoam)" -gt 1 ] || fail "no function was added"
    expectEqual "bases built again" "$(grep -c 'harmonicBasis: .* functions' continued/log.pimpleFoam)" 1
}

property fallenBack "so does harmonicBasis after it has fallen back, though the reason is gone"
fallenBack()
{
    makeFluid whole
    entry constant/dynamicMeshDict harmonicBasisCoeffs '{ memoryLimit 0; }'
    runFluid
    stopAndCopy
    entry constant/dynamicMeshDict harmonicBasisCoeffs '{}'
    goOn
    expectText log.pimpleFoam "the mesh moves as by displacementLaplacian" "more than the 'memoryLimit' of 0"
    expectSameHistory 1e-12
}

property ascii "files of twelve digits give the history to as many as the solvers leave"
ascii()
{
    makeFluid whole
    entry system/controlDict writeFormat ascii
    entry system/controlDict writePrecision 12
    tightenSolvers
    runFluid
    stopAndCopy
    goOn
    # Correctors of both runs end 1e-8 or so off the solution
    expectSameHistory 1e-7
}

property backward "the second order scheme backward goes on with its old times"
backward()
{
    makeFluid whole
    entry system/fvSchemes ddtSchemes.default backward
    expectExact
}

property crankNicolson "so does CrankNicolson with its rates"
crankNicolson()
{
    makeFluid whole
    entry system/fvSchemes ddtSchemes.default "CrankNicolson 0.9"
    expectExact
}

property adjusted "a run whose time step the fluid adjusts goes on as well"
adjusted()
{
    makeFluid whole
    entry system/controlDict adjustTimeStep yes
    entry system/controlDict maxCo 2
    entry system/controlDict timePrecision 12
    runFluid
    stopAndCopy
    goOn
    cd ..
    tipFrom whole 0 | awk '$1 > 0.0500001' > whole.tip
    tipFrom continued 0.05 > continued.tip
    # Times of files and of the run differ by rounding
    expectSameTable "tip" 1e-9 whole.tip continued.tip
}

property parallel "two ranks go on digit by digit"
parallel()
{
    makeFluid whole
    decompose 2
    expectExact 2
}

property otherRanks "a run goes on with another number of ranks"
otherRanks()
{
    makeFluid whole
    # Distances from a patch, which other diffusivities take, depend on the ranks
    entry constant/dynamicMeshDict harmonicBasisCoeffs.diffusivity uniform
    tightenSolvers
    decompose 2
    runFluid 2
    stopAndCopy
    reconstructPar -latestTime > log.reconstructPar 2>&1 || fail "reconstructPar failed"
    rm -rf processor*
    entry system/decomposeParDict numberOfSubdomains 3
    entry system/decomposeParDict coeffs.n '(3 1 1)'
    decomposePar -latestTime > log.decomposePar 2>&1 || fail "decomposePar failed"
    goOn 3
    expectNoText log.igaStructure "history are reset"
    # Both end 1e-8 or so off the solution
    expectSameHistory 1e-7
    cd continued
    rm -rf log.igaStructure [1-9]* 0.0[6-9] 0.1 processor* structure/results/states/flap_0.1.state
    goOn
    expectSameHistory 1e-7
}

property noState "a time without a saved state is refused on both sides, and those with one are named"
noState()
{
    makeFluid fluid
    entry system/controlDict writeInterval 0.02
    runFluid
    rm structure/results/states/flap_0.1.state
    entry system/controlDict startFrom latestTime
    entry system/controlDict endTime 0.2
    runFaultyFluid
    expectText log.pimpleFoam "the structure ended: the fluid starts at 0.1 s with a displaced interface" \
        "it has: 0.02 s, 0.04 s, 0.06 s, 0.08 s"
    expectText log.igaStructure "the fluid starts at 0.1 s with a displaced interface"
}

property otherState "a saved state that is not the fluid's is refused"
otherState()
{
    makeFluid fluid
    runFluid
    mv structure/results/states/flap_0.1.state structure/results/states/flap_0.05.state
    entry system/controlDict startFrom startTime
    entry system/controlDict startTime 0.05
    runFaultyFluid
    expectText log.pimpleFoam "the fluid's interface at its start time 0.05 s is not where the structure's saved state has it"
}

property otherStructure "another discretisation cannot go on from a saved state"
otherStructure()
{
    makeFluid fluid
    runFluid
    entry system/controlDict startFrom latestTime
    entry system/controlDict endTime 0.2
    flapEntry "elements: [2, 16]" "elements: [2, 8]"
    runFaultyFluid
    expectText log.pimpleFoam "the saved state of 0.1 s has" "start from an undeformed mesh"
}

property damagedState "a saved state of which one byte is damaged is refused with its file"
damagedState()
{
    makeFluid fluid
    runFluid
    printf 'x' | dd of=structure/results/states/flap_0.1.state bs=1 seek=300 conv=notrunc 2> /dev/null
    entry system/controlDict startFrom latestTime
    entry system/controlDict endTime 0.2
    runFaultyFluid
    expectText log.pimpleFoam "results/states/flap_0.1.state': the state is damaged"
}

# withoutFile FILE: a run of ten steps, whose time 0.05 lacks it
withoutFile()
{
    makeFluid whole
    runFluid
    stopAndCopy
    rm "0.05/$1"
}

property noPoints "a time without the mesh's points is refused, and they are named"
noPoints()
{
    withoutFile polyMesh/points
    runFaultyFluid
    expectText log.pimpleFoam "no points of the mesh, 0.05/polyMesh/points" "Start from a time that has both"
}

property noPointsParallel "the points of the mesh that two ranks lack are named as well"
noPointsParallel()
{
    makeFluid whole
    decompose 2
    runFluid 2
    stopAndCopy
    rm processor*/0.05/polyMesh/points
    runFaultyFluid 2
    expectText log.pimpleFoam "no points of the mesh, 0.05/polyMesh/points"
}

property noFaceVelocity "a time without Uf is used with a warning that names it"
noFaceVelocity()
{
    withoutFile Uf
    goOn
    expectText log.pimpleFoam "has no file 0.05/Uf: the solver interpolates it anew"
}

property noPointDisplacement "a time without pointDisplacement is refused, and it is named"
noPointDisplacement()
{
    withoutFile pointDisplacement
    runFaultyFluid
    expectText log.pimpleFoam "0.05/pointDisplacement" "start from a time that has it"
}

property purgeWrite "saved states go with the fluid's times, and each time that is left can be started from"
purgeWrite()
{
    makeFluid fluid
    entry system/controlDict writeInterval 0.01
    entry system/controlDict purgeWrite 2
    runFluid
    expectEqual "the fluid's times" "$(ls -d 0* | tr '\n' ' ')" "0 0.09 0.1 "
    # When the last one was saved, the fluid had those of 0.08 and 0.09
    expectEqual "states" "$(cd structure/results/states; ls | tr '\n' ' ')" \
        "flap_0.08.state flap_0.09.state flap_0.1.state "
    entry system/controlDict startFrom startTime
    entry system/controlDict startTime 0.09
    runFluid
    expectText log.igaStructure "restarting from the saved state at t = 0.09 s"
}

property purgeWriteParallel "saved states go with the fluid's times on two ranks as well"
purgeWriteParallel()
{
    makeFluid fluid
    entry system/controlDict writeInterval 0.01
    entry system/controlDict purgeWrite 2
    decompose 2
    runFluid 2
    expectEqual "states" "$(cd structure/results/states; ls | tr '\n' ' ')" \
        "flap_0.08.state flap_0.09.state flap_0.1.state "
}

property twoRuns "a second run in the same results folder is refused with process and host"
twoRuns()
{
    makeFluid fluid
    entry system/controlDict endTime 1000
    flapEntry "time: {}" "time: {step: 0.01, end: 1}"
    startFluid
    waitForText log.igaStructure "step 3 "
    if igaStructure run structure/case.yaml > second.log 2>&1
    then
        fail "the second run has started"
    fi
    kill -KILL "$fluid"
    wait "$fluid" 2> /dev/null || true
    expectText second.log "structure/results' is in use: process " " on $(hostname)"
    expectNoProcess 10
}

property fromRest "a run from an undeformed mesh leaves saved states of earlier runs alone"
fromRest()
{
    makeFluid whole
    runFluid
    tipFrom . 0 > ../whole.tip
    runFluid
    expectNoText log.igaStructure "goes on"
    tipFrom . 0 > ../again.tip
    cmp -s ../whole.tip ../again.tip || fail "the second run is another one"
}

runProperties "$@"
