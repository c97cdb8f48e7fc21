#!/usr/bin/env bash
# The flap of tutorials/perpendicularFlap on a coarse mesh: pimpleFoam and
# igaStructure as a user runs them.
source "$(dirname "$0")/harness.sh"

# watchPoints: "time ux uy" of the tip, a step a row
watchPoints()
{
    grep -v '^#' "${1:-.}/structure/postProcessing/flap/0/watchPoints.dat"
}

property run "fluid and structure run together, step by step, to the end"
run()
{
    makeFlap fluid
    entry system/controlDict writeInterval 0.01
    runFluid
    expectText log.pimpleFoam "structureCoupling structure:" "strong coupling, tolerance 0.0001" "15 points"
    expectText log.igaStructure "step 3 time 0.03 s" "the fluid ends the run: the fluid's run has ended"
    expectEqual "times of the fluid" "$(grep -v '^#' postProcessing/structure/0/coupling.dat | awk '{ printf "%.6g ", $1 }')" "0.01 0.02 0.03 "
    expectEqual "times of the structure" "$(watchPoints | awk '{ printf "%.6g ", $1 }')" "0.01 0.02 0.03 "
    expectEqual "converged steps" "$(grep -v '^#' postProcessing/structure/0/coupling.dat | awk '{ print $7 }' | sort -u)" 1
    expectEqual "times of the structure's results" \
        "$(sed -n 's/.*timestep="\([^"]*\)".*/\1/p' structure/results/flap.pvd | awk '{ printf "%.6g ", $1 }')" \
        "0 0.01 0.02 0.03 "
}

property parallel "two ranks give the tip's history of one"
parallel()
{
    local case
    for case in serial parallel
    do
        makeFlap $case
        entry system/controlDict endTime 0.1
    done
    cd ../serial
    runFluid
    cd ../parallel
    decompose 2
    runFluid 2
    cd ..
    for case in serial parallel
    do
        watchPoints $case | awk '{ print $2, $3 }' > $case.tip
    done
    expectEqual "steps" "$(wc -l < serial.tip)" 10
    # Steps converged to 1e-4 each
    expectSameTable "tip" 1e-4 serial.tip parallel.tip
}

property intervals "the tip moves alike whether every outer corrector is coupled or only a converged flow"
intervals()
{
    local interval
    for interval in 1 fluidConverged
    do
        makeFlap every.$interval
        entry system/controlDict endTime 0.1
        coupling couplingInterval $interval
        entry system/fvSolution PIMPLE.residualControl.structure.tolerance 1e-6
        entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-6
        runFluid
        cd ..
        watchPoints every.$interval | awk '{ print $2, $3 }' > $interval.tip
    done
    expectEqual "steps" "$(wc -l < fluidConverged.tip)" 10
    # Steps converged to 1e-6 each
    expectSameTable "tip" 1e-4 1.tip fluidConverged.tip
}

property adjusted "the structure follows a time step that the fluid adjusts"
adjusted()
{
    makeFlap fluid
    entry system/controlDict adjustTimeStep yes
    entry system/controlDict maxCo 1
    entry system/fvSchemes ddtSchemes.default backward
    runFluid
    # The fluid's log has six digits
    watchPoints | awk '{ printf "%.6g\n", $1 }' > structureTimes
    awk '$1 == "Time" && $2 == "=" { printf "%.6g\n", $3 }' log.pimpleFoam > fluidTimes
    [ "$(wc -l < fluidTimes)" -gt 3 ] || fail "the time step was not adjusted"
    cmp -s structureTimes fluidTimes || fail "the structure's times are not the fluid's"
}

property explicit "explicit coupling solves the structure once a step"
explicit()
{
    makeFlap fluid
    entry system/fvSolution PIMPLE.nOuterCorrectors 1
    runFluid
    expectEqual "coupling iterations per step" \
        "$(grep -v '^#' structure/postProcessing/flap/0/iterations.dat | awk '{ print $2 }' | sort -u)" 1
}

runProperties "$@"
