#!/usr/bin/env bash
# What fluid and structure say of the interface, and the warning if they differ.
source "$(dirname "$0")/harness.sh"

# Rows of the table: time, then of the fluid and of the structure force (3),
# moment (3), power and swept volume, then four relative differences
balance()
{
    grep -v '^#' "${1:-.}/postProcessing/structure/0/conservation.dat"
}

# largest COLUMN: of the last columns, the differences: 1 force ... 4 swept volume
largest()
{
    balance | awk -v c="$1" '{ x = $(17 + c); if (x > most) most = x } END { printf "%.3g\n", most }'
}

# expectBelow WHAT ACTUAL LIMIT
expectBelow()
{
    awk -v x="$2" -v limit="$3" 'BEGIN { exit !(x < limit) }' || fail "$1: $2, not below $3"
}

# makeTightFlap FOLDER: steps converged to 1e-8
makeTightFlap()
{
    makeFlap "$1"
    entry system/fvSolution PIMPLE.residualControl.structure.tolerance 1e-8
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-6
}

# transposeLoads: power is then the same to rounding, on any mesh
transposeLoads()
{
    flapEntry "interface: [left, top, right]" "interface: [left, top, right]
  mapping: {loads: transposed}"
}

property balances "with transposed loads force, moment, power and swept volume are the same on both sides"
balances()
{
    makeTightFlap fluid
    transposeLoads
    runFluid
    expectEqual "rows" "$(balance | awk '{ printf "%.6g ", $1 }')" "0.01 0.02 0.03 "
    # Columns of six digits that are no zeros
    balance | awk '{ for (i = 2; i <= 17; ++i) if (i % 8 != 4 && i % 8 != 5 && i % 8 != 6 && $i == 0) exit 1 }' \
        || fail "a quantity is zero"
    expectBelow "force" "$(largest 1)" 1e-10
    # The positions of the two sides differ by the coupling residual
    expectBelow "moment" "$(largest 2)" 1e-8
    expectBelow "power" "$(largest 3)" 1e-6
    expectBelow "swept volume" "$(largest 4)" 1e-6
    expectNoText log.pimpleFoam "conservationLimit"
}

property integrated "integrated loads keep the force, and moment and power to the order of the faces"
integrated()
{
    makeTightFlap fluid
    runFluid
    expectBelow "force" "$(largest 1)" 1e-10
    # Six faces along the height: moment and power err by the square of a face over
    # the length of the deflection, and the latter is not small in the first step
    expectBelow "moment" "$(largest 2)" 1e-4
    expectBelow "power" "$(largest 3)" 0.04
    expectBelow "swept volume" "$(largest 4)" 1e-6
}

property default "with the tutorial's tolerances they differ less than the limit"
default()
{
    makeFlap fluid
    transposeLoads
    entry system/controlDict endTime 0.1
    runFluid
    expectBelow "force" "$(largest 1)" 1e-10
    expectNoText log.pimpleFoam "conservationLimit"
}

property foam "the fluid's force and moment are those of OpenFOAM's function object"
foam()
{
    makeFlap fluid
    entry system/controlDict functions.forces \
        '{ type forces; libs (forces); patches (flap); rho rhoInf; rhoInf 1; CofR (0 0 0); writePrecision 10; }'
    runFluid
    balance | awk '{ print $2, $3, $7 }' > actual
    # In 2D only the moment about the empty direction counts
    paste -d ' ' <(grep -v '^#' postProcessing/forces/0/force.dat | tr -d '()' | awk '{ print $2, $3 }') \
        <(grep -v '^#' postProcessing/forces/0/moment.dat | tr -d '()' | awk '{ print $4 }') > expected
    # Six digits
    expectSameTable "force and moment" 2e-6 expected actual
}

property planes "they are the same in a mesh of any plane and thickness, of one or two ranks"
planes()
{
    local mesh
    for mesh in plane xz yz
    do
        makeFlap $mesh $mesh
        runFluid
        cd ..
    done
    # x, y, z: of the first plane's directions along and across the flow
    balance plane | awk '{ print $2, $3, $7, $8, $9, $10, $11, $15, $16, $17 }' > plane.table
    balance xz | awk '{ print $2, $4, -$6, $8, $9, $10, $12, -$14, $16, $17 }' > xz.table
    balance yz | awk '{ print $3, $4, $5, $8, $9, $11, $12, $13, $16, $17 }' > yz.table
    # Steps converged to 1e-4 each
    expectSameTable "xz" 1e-4 plane.table xz.table
    expectSameTable "yz" 1e-4 plane.table yz.table
    makeFlap parallel thin
    decompose 2
    runFluid 2
    balance | awk '{ print $2/0.1, $3/0.1, $7/0.1, $8/0.1, $9/0.1, $10/0.1, $11/0.1, $15/0.1, $16/0.1, $17/0.1 }' > ../parallel.table
    cd ..
    expectSameTable "two ranks" 1e-4 plane.table parallel.table
}

property gap "a structure that is too short for the fluid's patch is warned of"
gap()
{
    makeFlap fluid
    flapEntry "size: [0.1, 1]" "size: [0.1, 0.7]"
    flapEntry "interface: [left, top, right]" "interface: [left, top, right]
  mapping: {gapLimit: 0.5}"
    sed -i '/^output/,$d' structure/case.yaml
    runFluid
    expectText log.pimpleFoam "the moment of the interface differs between fluid and structure by" \
        "the two surfaces do not lie on each other"
    expectEqual "warnings" "$(grep -c 'the moment of the interface differs' log.pimpleFoam)" 1
    expectBelow "force" "$(largest 1)" 1e-10
}

property limit "the limit can be chosen"
limit()
{
    makeFlap fluid
    coupling conservationLimit 1e-20
    runFluid
    expectText log.pimpleFoam "the power of the interface differs" "the sweptVolume of the interface differs" \
        "conservationLimit 1e-20"
}

property off "without the audit there is no table"
off()
{
    makeFlap fluid
    coupling conservationLimit off
    runFluid
    [ ! -e postProcessing/structure/0/conservation.dat ] || fail "there is a table"
}

property badLimit "a limit that is none is refused"
badLimit()
{
    makeFlap fluid
    coupling conservationLimit 0
    runFaultyFluid
    expectText log.pimpleFoam "'conservationLimit' is 0: it must be a positive number or 'off'"
}

runProperties "$@"
