#!/usr/bin/env bash
# The coupled time step inside the PIMPLE loop.
source "$(dirname "$0")/harness.sh"

# steps RECORD: "time deltaT iterations finalIterations writes" of each step
steps()
{
    awk '
        function flush() { if (time != "") print time, deltaT, iterations, finals, writes }
        $1 == "step" { flush(); time = $3; deltaT = $4; iterations = finals = writes = 0 }
        $1 == "forces" { ++iterations; finals += $3; writes += $4 }
        END { flush() }' "$1"
}

# Rows of the table that the coupling writes
table()
{
    grep -v '^#' postProcessing/structure/0/coupling.dat
}

# Folders that pimpleFoam has written, besides the start
timeFolders()
{
    local folder
    for folder in [0-9]*
    do
        [ "$folder" = 0 ] || printf '%s ' "$folder"
    done
}

property frozen "the displacement stays as it was in the final corrector"
frozen()
{
    makeCase fluid
    # Each coupling iteration of a step moves the flap further, the last one too
    behave creeps
    entry system/controlDict writeInterval 0.03
    runFluid
    movedPoints constant/polyMesh/points 0.03/polyMesh/points \
        | awk '$1 == 0.05 && $2 == 1 && $3 == 0 { print $4 }' > moved
    # Corrector k + 1 moves by answer k, answer 0 being the prediction; the
    # final corrector n keeps what corrector n - 1 had
    awk -v OFMT=%.15g '
        $1 == "points" { for (i = 2; i <= NF; i += 2) if ($i == 0.05 && $(i + 1) == 1) tip = i + 2 }
        $1 == "forces" && $2 == 0.03 { ++n }
        $1 == "answer" && $2 == 0.03 { answer[m++] = $tip }
        END { print answer[n - 2] > "expected"; print answer[n - 1] > "notExpected" }' record
    # Coordinates of 14 digits; the answers differ by 0.2 %
    expectSameTable "displacement of the tip" 1e-11 expected moved
    if cmp -s expected notExpected
    then
        fail "the answers of the structure do not differ"
    fi
}

property iterations "each outer corrector has one coupling iteration, the last one final"
iterations()
{
    makeCase fluid
    behave creeps
    runFluid
    steps record > steps
    expectEqual "steps" "$(awk '{ print $1, $2 }' steps | tr '\n' ' ')" \
        "0.01 0.01 0.02 0.01 $(awk 'NR == 3 { print $1, $2 }' steps) "
    expectEqual "final iterations per step" "$(cut -d ' ' -f 4 steps | sort -u)" 1
    expectEqual "coupling iterations" "$(cut -d ' ' -f 3 steps | tr '\n' ' ')" \
        "$(grep 'PIMPLE: converged in' log.pimpleFoam | awk '{ print $4 }' | tr '\n' ' ')"
    # The fourth coupling iteration converges, and one more is final
    awk '$3 < 5 { exit 1 }' steps || fail "a step has ended before the structure had converged"
}

property judged "a final outer corrector that leaves too large a residual is followed by others"
judged()
{
    makeCase fluid
    behave asksOnce
    runFluid
    steps record > steps
    expectEqual "final iterations per step" "$(cut -d ' ' -f 4 steps | sort -u)" 2
    # The loop has gone on, and its last corrector is the one in the table
    expectEqual "outer correctors" "$(table | awk '{ print $3 }' | tr '\n' ' ')" \
        "$(grep 'PIMPLE: converged in' log.pimpleFoam | awk '{ print $4 }' | tr '\n' ' ')"
    expectEqual "residual" "$(table | awk '{ print $5 + 0 }' | sort -u)" 0
    expectEqual "converged" "$(table | awk '{ print $7 }' | sort -u)" 1
}

property neverAccepted "a step whose last outer corrector leaves too large a residual did not converge"
neverAccepted()
{
    makeCase fluid
    behave asksForever
    entry system/fvSolution PIMPLE.nOuterCorrectors 12
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 0.01
    runFaultyFluid
    expectText log.pimpleFoam "time 0.01 s did not converge in 12 outer correctors" \
        "structure 1 (tolerance 0.0001)"
}

property acceptedNevertheless "such a step is accepted with a warning, if the case asks for that"
acceptedNevertheless()
{
    makeCase fluid
    behave asksForever
    entry system/fvSolution PIMPLE.nOuterCorrectors 12
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 0.01
    coupling onUnconverged warn
    runFluid
    expectText log.pimpleFoam "accepted nevertheless, by 'onUnconverged warn'"
    expectEqual "outer correctors" "$(table | awk '{ print $3 }' | sort -u)" 12
}

property couplingInterval "with an interval of two every second outer corrector is coupled, and the final one"
couplingInterval()
{
    makeCase fluid
    behave creeps
    coupling couplingInterval 2
    runFluid
    expectEqual "converged" "$(table | awk '{ print $7 }' | sort -u)" 1
    # n coupling iterations of two outer correctors each, then the final one
    table | awk '$3 != 2*($4 - 1) + 1 || $4 < 5 { exit 1 }' || fail "outer correctors and coupling iterations: $(table | cut -f 3,4)"
}

property fluidConverged "a coupling iteration waits until the flow has converged, if the case asks for it"
fluidConverged()
{
    makeCase fluid
    behave creeps
    coupling couplingInterval fluidConverged
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-5
    # Enough for four coupling iterations with a converged flow
    entry system/fvSolution PIMPLE.nOuterCorrectors 100
    runFluid
    expectEqual "converged" "$(table | awk '{ print $7 }' | sort -u)" 1
    awk '$1 == "forces" && $3 == 0 { ++n; if (!($5 < 1e-5)) bad = 1 } END { exit bad || n < 12 }' record \
        || fail "a coupling iteration with a flow that has not converged"
    table | awk '$3 < 2*$4 { exit 1 }' || fail "as many coupling iterations as outer correctors"
}

property planeInSpace "in a plane flow in space the residual of the noise across does not count"
planeInSpace()
{
    local field
    makeCase fluid solid
    entry constant/polyMesh/boundary entry0.frontAndBack.type symmetry
    for field in p U pointDisplacement
    do
        entry 0/$field boundaryField.frontAndBack.type symmetry
    done
    runFluid
    # The log has 12 digits
    awk '$1 == "forces" { printf "%.6e\n", $5 }' record > residuals
    awk '/Solving for Ux/ { x = $8 + 0 } /Solving for Uy/ { y = $8 + 0 }
         /Solving for Uz/ { z = $8 + 0; printf "%.6e\n", (x > y ? x : y); if (z > x && z > y) ++across }
         END { print across + 0 > "across" }' log.pimpleFoam > inPlane
    expectSameTable "momentum residuals" 1e-5 residuals inPlane
    [ "$(cat across)" -gt 0 ] || fail "there is no noise across the flow"
}

# pressures LOG: "initial final accepted last" of each solution of the pressure and
# of the flux correction, the residuals and whether it is in a final corrector and
# the last one in its corrector
pressures()
{
    awk '
        function flush(accepted, i) {
            for (i = 1; i <= n; ++i) print solution[i], accepted, i == n
            n = 0
        }
        /^PIMPLE: iteration/ { flush(0) }
        /^PIMPLE: converged in/ { flush(1) }
        /Solving for p(corr)?,/ { solution[++n] = $8 + 0 " " $12 + 0 }' "$1"
}

# makeTolerance FOLDER CHOICE: a flow that converges well below what is compared
makeTolerance()
{
    cd "$propertyFolder"
    makeCase "$1"
    behave creeps
    coupling pressureTolerance "$2"
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-8
    entry system/fvSolution PIMPLE.nOuterCorrectors 100
}

# In the table pressures, the last one of a corrector is solved to a tenth, and in
# the final corrector as the case has it
expectLoose()
{
    awk '!$3 && $4 && $2 > 1e-8 { ++loose; if ($2 > 0.1*$1) exit 1 } END { exit loose < 12 }' pressures \
        || fail "the last pressure of a corrector was not solved to a tenth"
    awk '$3 && $4 { ++n; if ($2 > 1e-8) exit 1 } END { exit n != 3 }' pressures \
        || fail "an accepted pressure is not as tight as the case asks"
}

property pressureTolerance "relaxed, the pressure is solved loosely until the final outer corrector"
pressureTolerance()
{
    makeTolerance own fixed
    runFluid
    pressures log.pimpleFoam > pressures
    awk '$4 && $2 > 1e-8 { exit 1 }' pressures || fail "the pressure was not solved as the case asks"
    makeTolerance loose relaxed
    runFluid
    pressures log.pimpleFoam > pressures
    expectLoose
    # Flows converge to 1e-8 in momentum
    finalForces ../own/record 0.03 > own.forces
    finalForces record 0.03 > loose.forces
    expectSameTable "forces" 1e-6 own.forces loose.forces
    cmp -s system/fvSolution ../own/system/fvSolution || fail "the run has changed fvSolution"
}

property tolerancePattern "it relaxes no other solver where a pattern matches all of the pressure solvers"
tolerancePattern()
{
    makeTolerance fluid relaxed
    removeEntry system/fvSolution solvers.pFinal
    removeEntry system/fvSolution solvers.p
    sed -i 's/"pcorr\.\*"/"p.*"/; s/tolerance  *1e-0*6;/tolerance 1e-8;/' system/fvSolution
    runFluid
    pressures log.pimpleFoam > pressures
    expectLoose
    awk '!$4 && $2 > 1e-8 { exit 1 }' pressures || fail "another solution has been loosened"
}

# accelerate FOLDER CHOICE: a fluid almost without viscosity and convection, in which
# velocities grow linearly and the pressure is constant; prints the first residual of Ux
# in the last time step
accelerate()
{
    cd "$propertyFolder"
    makeCase "$1"
    coupling fluidPredictor "$2"
    entry system/controlDict endTime 0.2
    entry constant/transportProperties nu 1e-12
    sed -i 's/^\(internalField *\)uniform (10 0 0);/\1uniform (0 0 0);/
        s/fixedValue;/uniformFixedValue; uniformValue table ((0 (0 0 0)) (1 (1e-3 0 0)));/' 0/U
    runFluid
    awk '/^Time = 0.2$/ { last = 1 } last && /Solving for Ux/ { sub(",", "", $8); print $8; exit }' log.pimpleFoam
}

property fluidPredictor "a flow whose velocities grow linearly in time is predicted"
fluidPredictor()
{
    local without with
    without=$(accelerate none none)
    with=$(accelerate linear linear)
    # What is left is the convection and what dies out after the start
    awk -v a="$without" -v b="$with" 'BEGIN { exit !(a > 0.1 && b < 0.01*a) }' \
        || fail "first residual of Ux: $without without prediction, $with with it"
}

property lastIteration "before the final outer corrector there is a coupling iteration, whatever the interval"
lastIteration()
{
    neverConverge
    coupling onUnconverged warn
    coupling couplingInterval 4
    runFluid
    # Correctors 4, 5 and the final one of 6
    expectEqual "coupling iterations" "$(steps record | cut -d ' ' -f 3,4 | sort -u)" "3 1"
}

property rows "the coupling's table has one row a step"
rows()
{
    makeCase fluid
    behave creeps
    runFluid
    steps record | awk '{ printf "%.6g %.6g %d\n", $1, $2, $3 }' > expected
    table | awk '{ printf "%.6g %.6g %d\n", $1, $2, $4 }' > rows
    cmp -s expected rows || fail "$(cat rows) in place of $(cat expected)"
    expectEqual "converged" "$(table | awk '{ print $7 }' | sort -u)" 1
}

property folders "no time folder appears that was not asked for"
folders()
{
    makeCase fluid
    behave creeps
    entry system/controlDict endTime 0.05
    entry system/controlDict writeInterval 0.02
    runFluid
    expectEqual "time folders" "$(timeFolders)" "0.02 0.04 "
}

property writeTimes "the structure is told to write when the fluid writes"
writeTimes()
{
    makeCase fluid
    entry system/controlDict endTime 0.05
    entry system/controlDict writeInterval 0.02
    runFluid
    expectEqual "steps that write" "$(steps record | awk '$5 == 1 { printf "%.6g ", $1 }')" "0.02 0.04 "
    expectEqual "final iterations that write" \
        "$(awk '$1 == "forces" && $4 == 1 { print $3 }' record | sort -u)" 1
}

property adjusted "the structure gets the time step that the fluid adjusts"
adjusted()
{
    makeCase fluid
    behave sway
    entry system/controlDict adjustTimeStep yes
    entry system/controlDict maxCo 1
    entry system/controlDict writeInterval 0.015
    runFluid
    steps record > steps
    [ "$(awk '{ printf "%.5g\n", $2 }' steps | sort -u | wc -l)" -gt 2 ] \
        || fail "the time step was not adjusted"
    awk -v OFMT=%.12g '{ print $1, $2 }' steps > told
    # The times follow from the time steps, and are those of the fluid's log
    awk -v OFMT=%.12g '{ time += $2; print time, $2 }' steps > summed
    expectSameTable "times" 1e-12 told summed
    awk '$1 == "deltaT" { deltaT = $3 } $1 == "Time" && $2 == "=" { print $3, deltaT }' log.pimpleFoam > logged
    # The log has six digits
    expectSameTable "time steps" 1e-5 told logged
    expectEqual "time folders" "$(timeFolders)" "0.015 0.03 "
}

property backward "the time scheme backward couples as Euler does"
backward()
{
    makeCase fluid
    behave sway
    entry system/fvSchemes ddtSchemes.default backward
    entry system/controlDict functions.forces \
        '{ type forces; libs (forces); patches (flap); rho rhoInf; rhoInf 1; CofR (0 0 0); writePrecision 16; }'
    runFluid
    expectEqual "accepted steps" "$(steps record | awk '$4 == 1' | wc -l)" 3
    tr -d '()' < postProcessing/forces/0/force.dat | awk '$1 == 0.03 { print $2, $3, 0 }' > foam
    forceSum record 0.03 > sum
    # Rounding of 14 terms
    expectSameTable force 1e-12 foam sum
}

property explicit "with one outer corrector the coupling is explicit"
explicit()
{
    makeCase fluid
    behave sway
    entry system/fvSolution PIMPLE.nOuterCorrectors 1
    removeEntry system/fvSolution PIMPLE.moveMeshOuterCorrectors
    removeEntry system/fvSolution PIMPLE.residualControl
    runFluid
    expectText log.pimpleFoam "explicit coupling, one coupling iteration per time step"
    expectEqual "coupling iterations per step" "$(steps record | cut -d ' ' -f 3,4 | sort -u)" "1 1"
    expectEqual "rows" "$(table | wc -l)" 3
}

# Six correctors, and a structure that asks for more each time
neverConverge()
{
    makeCase fluid
    behave neverConverges
    entry system/fvSolution PIMPLE.nOuterCorrectors 6
}

property abort "a step that does not converge ends the run, and says what to change"
abort()
{
    neverConverge
    runFaultyFluid
    expectText log.pimpleFoam "time 0.01 s did not converge in 6 outer correctors: above the tolerance of residualControl: structure 1 (tolerance 0.0001)" \
        "Raise nOuterCorrectors" "'onUnconverged warn'"
    expectText log.igaStructure "the fluid ended: time 0.01 s did not converge in 6 outer correctors"
    expectEqual "final iterations" "$(steps record | cut -d ' ' -f 4)" 0
}

property warn "a step that does not converge is accepted by the option warn, and warned of"
warn()
{
    neverConverge
    coupling onUnconverged warn
    runFluid
    expectText log.pimpleFoam "time 0.03 s did not converge in 6 outer correctors" "accepted nevertheless, by 'onUnconverged warn'"
    expectEqual "coupling iterations" "$(steps record | cut -d ' ' -f 3,4 | sort -u)" "6 1"
    expectEqual "converged" "$(table | awk '{ print $7 }' | sort -u)" 0
}

property unconvergedFlow "a step whose flow has not converged is not accepted either"
unconvergedFlow()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.nOuterCorrectors 3
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-9
    runFaultyFluid
    expectText log.pimpleFoam "time 0.01 s did not converge in 3 outer correctors: above the tolerance of residualControl: Ux " "; below it: structure 0 (tolerance 0.0001)"
}

property stopped "a run that is stopped early by controlDict ends in good order"
stopped()
{
    makeCase fluid
    entry system/controlDict stopAt nextWrite
    entry system/controlDict writeInterval 0.02
    entry system/controlDict endTime 100
    runFluid
    expectText log.igaStructure "goodbye: the fluid's run has ended"
    expectEqual "last step" "$(steps record | tail -n 1 | cut -d ' ' -f 1)" 0.02
    expectEqual "time folders" "$(timeFolders)" "0.02 "
}

runProperties "$@"
