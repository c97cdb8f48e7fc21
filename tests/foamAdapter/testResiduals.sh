#!/usr/bin/env bash
# What did not converge is named, entry by entry and component by component, and a
# direction along which nothing flows blocks no time step.
source "$(dirname "$0")/harness.sh"

property components "what did not converge is named by component, with value, tolerance and remedy"
components()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.nOuterCorrectors 3
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-9
    runFaultyFluid
    expectText log.pimpleFoam "time 0.01 s did not converge in 3 outer correctors: above the tolerance of residualControl: Ux " \
        "(tolerance 1e-09), Uy " "; below it: structure 0 (tolerance 0.0001)" \
        "See that the solvers' tolerances are below those of residualControl" "Raise nOuterCorrectors"
    expectText log.igaStructure "above the tolerance of residualControl: Ux "
    # The values are those of the log's last solutions
    sed -n 's/.*Solving for U\([xy]\), Initial residual = \([^,]*\),.*/\1 \2/p' log.pimpleFoam | tail -n 2 \
        | sed 's/^/U/' > solved
    tr -s '[:space:]' ' ' < log.pimpleFoam | grep -o 'U[xy] [0-9.e-]* (tolerance' | cut -d ' ' -f 1,2 | sort -u > named
    awk '{ print $2 }' solved | sort -g > solved.values
    awk '{ print $2 }' named | sort -g > named.values
    expectEqual "components" "$(cut -d ' ' -f 1 named | tr '\n' ' ')" "Ux Uy "
    # The message has four digits
    expectSameTable "residuals" 1e-3 solved.values named.values
}

property unconvergedCoupling "an unconverged coupling is named, beside the flow's components that have converged"
unconvergedCoupling()
{
    makeCase fluid
    behave neverConverges
    entry system/fvSolution PIMPLE.nOuterCorrectors 25
    runFaultyFluid
    expectText log.pimpleFoam "above the tolerance of residualControl: structure 1 (tolerance 0.0001); below it: Ux " \
        "Choose another acceleration in the structure's case file"
}

property pressureControl "residualControl of the pressure is warned of at the start, and named where it blocks"
pressureControl()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.residualControl.p '{ tolerance 1e-12; relTol 0; }'
    entry system/fvSolution PIMPLE.nOuterCorrectors 25
    runFaultyFluid
    expectText log.pimpleFoam "residualControl limits p to 1e-12: PIMPLE compares it with the initial residual of the last of the 2 pressure solutions" \
        "above the tolerance of residualControl: p " "Remove the pressure from residualControl"
}

# A plane flow in space: two cells across, between sides that nothing crosses
makeAcross()
{
    local field
    makeCase fluid solid
    sed -i 's/\<frontAndBack\>/front/; /front/,/}/s/type .*/type symmetry;/' constant/polyMesh/boundary
    for field in p U pointDisplacement
    do
        entry 0/$field boundaryField.frontAndBack '{ type symmetry; }'
        sed -i 's/frontAndBack/front/' 0/$field
    done
    entry system/fvSolution PIMPLE.consistent yes
    entry system/fvSolution PIMPLE.nCorrectors 2
}

property still "a component without flow blocks no time step, and is reported once"
still()
{
    makeAcross
    runFluid
    expectEqual "reports" "$(grep -c 'nothing flows along z: Uz is at most' log.pimpleFoam)" 1
    expectEqual "converged steps" "$(grep -c 'PIMPLE: converged in' log.pimpleFoam)" 3
    # It is noise that would have blocked, and the others are below their tolerance
    awk '/Solving for Uz/ && $8 + 0 > 1e-4 { ++n } END { exit !n }' log.pimpleFoam || fail "there is no noise across the flow"
    grep -v '^#' postProcessing/structure/0/coupling.dat | awk '$6 >= 1e-4 { exit 1 }' \
        || fail "a step was accepted above the tolerance of U"
}

runProperties "$@"
