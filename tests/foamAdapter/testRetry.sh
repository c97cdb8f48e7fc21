#!/usr/bin/env bash
# A time step that fails is taken back and repeated with a shorter one, and leaves
# no trace: the run is that with the short step from the start.
source "$(dirname "$0")/harness.sh"

# makeSwaying FOLDER BEHAVIOUR: a flow that converges well below what is compared
makeSwaying()
{
    makeCase "$1"
    behave "$2"
    sed -i 's/relTol  *0.01;/relTol 0;/; s/tolerance  *1e-8;/tolerance 1e-12;/' system/fvSolution
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-8
    entry system/fvSolution PIMPLE.nOuterCorrectors 100
    entry system/controlDict writeInterval 0.01
    entry system/controlDict functions.forces \
        '{ type forces; libs (forces); patches (flap); rho rhoInf; rhoInf 1; CofR (0 0 0); writePrecision 12; }'
}

# makeBoth BEHAVIOUR: long/ has steps that fail, short/ those of half the length
makeBoth()
{
    makeSwaying short "$1"
    entry system/controlDict deltaT 0.005
    makeSwaying long "$1"
    coupling onUnconverged retry
    cd ..
}

# inBoth COMMAND...
inBoth()
{
    local case
    for case in short long
    do
        cd "$propertyFolder/$case"
        "$@"
    done
    cd ..
}

# numbers FILE: of a field, those in parentheses first
numbers()
{
    grep '^(.*)$' "$1" | tr -d '()'
}

# stepLengths RECORD: "deltaT" of each step, "R" after those that are rejected
stepLengths()
{
    awk '$1 == "step" { printf "%.6g ", $4 } $1 == "rejected" { printf "R " }' "$1"
}

# rejectedTimes RECORD
rejectedTimes()
{
    awk '$1 == "rejected" { printf "%.6g ", $2 }' "$1"
}

# expectSameRun REJECTED: times that were rejected in long/
expectSameRun()
{
    local time table
    expectEqual "rejected steps" "$(rejectedTimes long/record)" "$1"
    for time in 0.01 0.02 0.03
    do
        finalForces short/record $time > short.forces
        finalForces long/record $time > long.forces
        # Steps converge to 1e-8, and the flow forgets
        expectSameTable "forces at $time" 1e-6 short.forces long.forces
        numbers short/$time/U > short.U
        numbers long/$time/U > long.U
        expectSameTable "velocity at $time" 1e-6 short.U long.U
        numbers short/$time/polyMesh/points > short.points
        numbers long/$time/polyMesh/points > long.points
        expectSameTable "points at $time" 1e-8 short.points long.points
    done
    for table in structure/0/coupling.dat forces/0/force.dat
    do
        expectEqual "times of $table" "$(rowTimes long/postProcessing/$table)" "$(rowTimes short/postProcessing/$table)"
    done
    expectEqual "lengths of the steps" "$(awk '!/^#/ { printf "%.6g ", $2 }' long/postProcessing/structure/0/coupling.dat)" \
        "0.005 0.005 0.005 0.005 0.005 0.005 "
    expectEqual "time folders" "$(cd long && ls -d 0.* | tr '\n' ' ')" "0.01 0.02 0.03 "
}

rowTimes()
{
    awk '!/^#/ { printf "%.6g ", $1 }' "$1"
}

property structure "a step that the structure cannot solve is repeated as if it had not been"
structure()
{
    makeBoth rejects
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
    expectEqual "steps" "$(stepLengths long/record)" "0.01 R 0.005 0.005 0.01 R 0.005 0.005 0.01 R 0.005 0.005 "
    expectText long/log.pimpleFoam "time step ending at t = 0.01 s rejected: no solution, as told" "retrying with deltaT = 0.005 s"
}

property unconverged "a step that does not converge is repeated as if it had not been"
unconverged()
{
    makeBoth convergesShort
    inBoth entry system/fvSolution PIMPLE.nOuterCorrectors 60
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
    expectText long/log.pimpleFoam "rejected: time 0.01 s did not converge in 60 outer correctors: above the tolerance of residualControl: structure 1"
}

property last "so is a step that fails in the exchange that should accept it"
last()
{
    makeBoth rejectsLast
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
}

property inverted "so is a step whose mesh motion inverts cells"
inverted()
{
    makeBoth leaps
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
    expectText long/log.pimpleFoam "cells without a positive volume at time 0.01 s: cell" "retrying with deltaT = 0.005 s"
}

property backward "so it is with the scheme backward, whose old times are taken back too"
backward()
{
    makeBoth rejects
    inBoth entry system/fvSchemes ddtSchemes.default backward
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
}

property crankNicolson "so it is with CrankNicolson and its rates"
crankNicolson()
{
    makeBoth rejects
    inBoth entry system/fvSchemes ddtSchemes.default "CrankNicolson 0.9"
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
}

property laplacian "so it is with a mesh that OpenFOAM's displacementLaplacian moves"
laplacian()
{
    makeBoth rejects
    inBoth useLaplacian
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
}

property fallback "so it is with harmonicBasis where it falls back in the step that fails"
fallback()
{
    makeBoth rejects
    inBoth entry constant/dynamicMeshDict harmonicBasisCoeffs '{ memoryLimit 0; }'
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
    expectText long/log.pimpleFoam "the mesh moves as by displacementLaplacian"
}

property parallel "so it is on two ranks"
parallel()
{
    makeBoth rejects
    inBoth decompose 2
    inBoth runFluid 2
    inBoth reconstructPar > log.reconstructPar 2>&1
    expectSameRun "0.01 0.02 0.03 "
}

property turbulence "so it is with a turbulence model, which the solver corrects after the step has failed"
turbulence()
{
    makeBoth rejects
    inBoth makeTurbulent
    inBoth runFluid
    expectSameRun "0.01 0.02 0.03 "
    grep '^[0-9.e+-]*$' short/0.03/k > short.k
    grep '^[0-9.e+-]*$' long/0.03/k > long.k
    expectSameTable "turbulent kinetic energy" 1e-6 short.k long.k
}

makeTurbulent()
{
    local field value
    printf 'FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }\n%s\n' \
        'simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }' \
        > constant/turbulenceProperties
    entry constant/transportProperties nu 0.01
    entry system/fvSchemes 'divSchemes.default' 'bounded Gauss upwind'
    sed -i '/^solvers/,/^{/ s|^{|{ "(k\|epsilon).*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-13; relTol 0; }|' \
        system/fvSolution
    for field in "k 1 [0 2 -2 0 0 0 0] kqRWallFunction" "epsilon 10 [0 2 -3 0 0 0 0] epsilonWallFunction" \
        "nut 0.009 [0 2 -1 0 0 0 0] nutkWallFunction"
    do
        makeTurbulentField "${field%% *}" "$(cut -d ' ' -f 2 <<< "$field")" \
            "$(cut -d ' ' -f 3-9 <<< "$field")" "${field##* }"
    done
}

# makeTurbulentField NAME VALUE DIMENSIONS WALLCONDITION
makeTurbulentField()
{
    local patch
    {
        printf 'FoamFile { version 2.0; format ascii; class volScalarField; object %s; }\n' "$1"
        printf 'dimensions %s; internalField uniform %s; boundaryField {\n' "$3" "$2"
        for patch in inlet outlet
        do
            printf '%s { type inletOutlet; inletValue uniform %s; value uniform %s; }\n' "$patch" "$2" "$2"
        done
        printf '"(flap|top|bottom|walls|.*[wW]all.*)" { type %s; value uniform %s; }\n' "$4" "$2"
        printf 'frontAndBack { type empty; } }\n'
    } > "0/$1"
}

property grows "after parts that do not fail the steps grow again, and meet the times of writing"
grows()
{
    makeSwaying fluid failsOnce
    coupling onUnconverged retry
    entry system/controlDict endTime 0.05
    runFluid
    expectEqual "steps" "$(stepLengths record)" \
        "0.01 0.01 R 0.005 R 0.0025 0.0025 0.005 0.005 0.005 0.01 0.01 "
    expectEqual "time folders" "$(ls -d 0.* | tr '\n' ' ')" "0.01 0.02 0.03 0.04 0.05 "
}

property adjusted "with adjustTimeStep the repeated step is shorter, and meets the times of writing"
adjusted()
{
    makeSwaying fluid rejects
    coupling onUnconverged retry
    entry system/controlDict adjustTimeStep yes
    entry system/controlDict maxCo 100
    runFluid
    [ -n "$(rejectedTimes record)" ] || fail "no step was rejected"
    expectEqual "time folders" "$(ls -d 0.* | tr '\n' ' ')" "0.01 0.02 0.03 "
    expectEqual "times of the forces" "$(rowTimes postProcessing/forces/0/force.dat)" \
        "$(rowTimes postProcessing/structure/0/coupling.dat)"
    awk '$1 == "step" { if (rejected && $4 >= last) exit 1; rejected = 0; last = $4 } $1 == "rejected" { rejected = 1 }' record \
        || fail "a repeated step is not shorter: $(stepLengths record)"
}

property smallest "below the smallest time step the run ends, and says why and what to change"
smallest()
{
    makeSwaying fluid neverConverges
    coupling onUnconverged retry
    coupling retry '{ minDeltaT 0.002; }'
    entry system/fvSolution PIMPLE.nOuterCorrectors 3
    runFaultyFluid
    expectEqual "steps" "$(stepLengths record)" "0.01 R 0.005 R 0.0025 "
    expectText log.pimpleFoam "time 0.0025 s did not converge in 3 outer correctors" \
        "Half of deltaT 0.0025 s would be below 'minDeltaT' 0.002 s of 'retry'"
    expectText log.igaStructure "the fluid ended: time 0.0025 s did not converge"
}

property flap "a first step that Newton's method does not solve is repeated as if it had not been"
flap()
{
    local case deltaT
    for case in short long
    do
        makeFlap $case
        entry system/controlDict endTime 0.04
        flapEntry "strains: linear" "strains: nonlinear"
        flapEntry "density: 3000" "density: 100"
        # The block method would get there in three iterations
        flapEntry "predictor: quadratic" "predictor: quadratic
  acceleration: {type: iqnIls}"
        printf 'newton: {reuseContraction: 0, tolerance: 1e-6}\n' >> structure/case.yaml
    done
    flapEntry "newton: {" "newton: {maxIterations: 3, "
    coupling onUnconverged retry
    runFluid
    expectText log.pimpleFoam "rejected: time 0.01 s, time step 0.01 s: Newton's method did not converge"
    expectText log.igaStructure "step 1 time 0.01 s is rejected: time 0.01 s"
    deltaT=$(awk '!/^#/ { print $2; exit }' postProcessing/structure/0/coupling.dat)
    cd ../short
    entry system/controlDict deltaT "$deltaT"
    entry system/controlDict endTime "$deltaT"
    runFluid
    cd ..
    awk '!/^#/ { print; exit }' long/structure/postProcessing/flap/0/watchPoints.dat > long.tip
    awk '!/^#/' short/structure/postProcessing/flap/0/watchPoints.dat > short.tip
    # The same operations on the same values
    expectSameTable tip 1e-10 short.tip long.tip
}

runProperties "$@"
