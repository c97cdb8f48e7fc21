#!/usr/bin/env bash
# The motion solver harmonicBasis: the mesh as a product.
source "$(dirname "$0")/harness.sh"

# makeSway FOLDER [MESH]: fakeStructure's sway
makeSway()
{
    makeCase "$1" "${2:-plane}"
    behave sway
    writeAtEnd
}

# basis KEY VALUE: sets an entry of the motion solver
basis()
{
    entry constant/dynamicMeshDict "harmonicBasisCoeffs.$1" "$2"
}

# moved FOLDER [TIME]: displacements of all points, the two planes of a 2D mesh too
moved()
{
    movedPoints "$1/constant/polyMesh/points" "$1/${2:-0.03}/polyMesh/points"
}

# oneStep: of a thousandth of the flap's height
oneStep()
{
    entry system/controlDict endTime 0.001
    entry system/controlDict deltaT 0.001
    entry system/controlDict writeInterval 0.001
}

property plane "harmonicBasis: in 2D the points of both planes follow the structure, in any plane"
plane()
{
    local mesh
    for mesh in "plane 1 2" "xz 1 3" "yz 2 3"
    do
        set -- $mesh
        makeSway "$1" "$1"
        runFluid
        moved . | flapPoints "$2" "$3" > moved
        expectSway "$2" "$3" moved 30
    done
}

property solid "harmonicBasis: in 3D the points of the surface follow the structure"
solid()
{
    makeSway fluid solid
    runFluid
    # At the foot nothing moves
    moved . | flapPoints 1 2 | awk '$2 > 0' > moved
    expectSway 1 2 moved 39 3
}

property others "harmonicBasis: points of the other walls stay, those between follow"
others()
{
    makeSway fluid
    runFluid
    moved . > all
    awk '$1 == -3 || $1 == 3 || $2 == 4 || ($2 == 0 && $1^2 > 0.003) { print $4, $5, $6 }' all | sort -u > still
    expectEqual "displacements of the outer boundary" "$(cat still)" "0 0 0"
    awk '$1^2 > 0.0026 && $1 > -2.9 && $1 < 2.9 && $2 > 0.1 && $2 < 3.9 && $4 == 0' all > stuck
    expectEqual "points between that did not follow" "$(wc -l < stuck)" 0
}

# skew: the outlet is inclined by up to 27 degrees, and the mesh has 2268 cells, for
# which the multigrid has levels
skew()
{
    local key
    for key in "nx 30" "nFlap 6" "nLow 18" "nHigh 18"
    do
        entry system/blockMeshDict "${key% *}" "${key#* }"
    done
    sed -i 's/( *\$x3 \$y1/(3.5 $y1/g; s/( *\$x3 \$y2/(5 $y2/g' system/blockMeshDict
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
}

property parallel "harmonicBasis: the mesh is the same on any number of ranks"
parallel()
{
    # So few cells are solved for directly
    compareRanks uniform 1e-7
    # OpenFOAM's inverse distance is some percent off at faces between ranks
    compareRanks 'inverseDistance (flap)' 1e-4
}

property levels "harmonicBasis: on a skewed mesh with levels too the mesh is the same on any number of ranks"
levels()
{
    # Both solve the extensions to 1e-6 of their energy
    compareRanks uniform 1e-5 skewAndOneStep 0.001
}

skewAndOneStep()
{
    skew
    oneStep
}

property turns "harmonicBasis: where no cell has a neighbour on its rank the mesh is the same too"
turns()
{
    # Nothing is aggregated, and 2358 unknowns are too many to be inverted. Sweeps
    # alone see too little of an error over all of the 69 cells across: the limit of
    # the other properties times (2/pi 69), the root of the matrix's condition
    compareRanks uniform 4e-4 oddAndOneStep 0.001 decomposeByTurns
    expectNoText log.pimpleFoam "have not converged"
}

# oddAndOneStep: 2358 cells, in lines of odd numbers of them
oddAndOneStep()
{
    local key
    for key in "nx 31" "nFlap 7" "nLow 18" "nHigh 18"
    do
        entry system/blockMeshDict "${key% *}" "${key#* }"
    done
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    oneStep
}

# decomposeByTurns RANKS: cell by cell, as a chessboard where lines are odd
decomposeByTurns()
{
    local nCells
    nCells=$(sed -n 's/.*nCells: *\([0-9]*\).*/\1/p' constant/polyMesh/owner)
    {
        printf 'FoamFile { version 2; format ascii; class labelList; object cellDecomposition; }\n(\n'
        awk -v n="$nCells" -v ranks="$1" 'BEGIN { for (; i < n; ++i) print i % ranks }'
        printf ')\n'
    } > constant/cellDecomposition
    entry system/decomposeParDict method manual
    entry system/decomposeParDict coeffs.dataFile '"cellDecomposition"'
    decompose "$1"
}

# compareRanks DIFFUSIVITY LIMIT [CHANGE TIME DECOMPOSE]: one rank and two, with a
# change of the case, at a time
compareRanks()
{
    local ranks time=${4:-0.03}
    makeSway "serial-${1%% *}"
    ${3:-true}
    basis diffusivity "$1"
    runFluid
    moved . "$time" | awk '{ $3 = 0; print }' | sort -u > ../one
    makeSway "parallel-${1%% *}"
    ${3:-true}
    basis diffusivity "$1"
    ${5:-decompose} 2
    runFluid 2
    reconstructPar -time "$time" > log.reconstructPar 2>&1 || fail "reconstructPar failed"
    reconstructParMesh -time "$time" > log.reconstructParMesh 2>&1 || true
    for ranks in 0 1
    do
        moved "processor$ranks" "$time"
    done | awk '{ $3 = 0; print }' | sort -u > two
    awk 'NR == FNR { u[$1 " " $2] = $4 " " $5; next } { print $4, $5 > "actual"; print u[$1 " " $2] > "expected" }' ../one two
    expectSameTable displacement "$2" expected actual
}

property laplacian "harmonicBasis: without rotation a small motion is that of a converged displacementLaplacian"
laplacian()
{
    compareSolution true
}

property skewed "harmonicBasis: on a skewed mesh too a small motion is that of a converged displacementLaplacian"
skewed()
{
    compareSolution skew
}

# compareSolution CHANGE: of the mesh
compareSolution()
{
    makeSway product
    "$1"
    basis rotation no
    basis diffusivity 'quadratic inverseDistance (flap)'
    oneStep
    runFluid
    moved . 0.001 | awk '{ print $4, $5 }' > ../product.moved
    cp -r . ../solution
    cd ../solution
    rm -rf 0.001 postProcessing
    useLaplacian
    runFluid
    moved . 0.001 | awk '{ print $4, $5 }' > moved
    # The motion is a thousandth of the flap's height, and the limit of the
    # diffusivity at the boundary makes a difference within the first cells
    expectSameTable displacement 0.02 ../product.moved moved
}

property rotation "harmonicBasis: points beside a side that turns turn with it, unless that is switched off"
rotation()
{
    # The sides of the flap, 0.05 from its middle, turn by the sway's slope, and a
    # point beside them goes down or up by that times its distance. The first points
    # are at 2.3 times the flap's half thickness, where the rotation has begun to fade
    makeSway turns
    runFluid
    beside > shares
    awk '!($1 > 0.7 && $1 < 1) { exit 1 }' shares || fail "shares of the rotation: $(cat shares | tr '\n' ' ')"
    expectEqual "points" "$(wc -l < shares)" 4
    makeSway still
    basis rotation no
    runFluid
    # Rounding of coordinates of 14 digits
    beside | awk '$1^2 > 1e-20 { exit 1 }' || fail "points turn without rotation"
}

# beside: of the points next to the sides at half their height and two thirds
beside()
{
    moved . | awk '$3 == 0 && $1^2 > 0.01 && $1^2 < 0.04 && $2 > 0.4 && $2 < 0.8 {
        distance = $1 > 0 ? $1 - 0.05 : $1 + 0.05
        print -$5/(distance*0.05*sin(20*0.03)) }'
}

property memory "harmonicBasis: where the boundary returns the mesh returns"
memory()
{
    makeSway fluid
    # Three steps of a third of the sway's half period
    # (foamDictionary would round them)
    sed -i 's/^\(deltaT\) .*/\1 0.0523598775598299;/
        s/^\(endTime\|writeInterval\) .*/\1 0.157079632679490;/' system/controlDict
    runFluid
    movedPoints constant/polyMesh/points 0.157*/polyMesh/points \
        | awk '{ print $4, $5, $6 }' | tr ' ' '\n' | sort -g > moved
    # The largest displacement has been 0.05
    awk 'function size(x) { return x < 0 ? -x : x } { if (size($1) > 1e-13) exit 1 }' moved \
        || fail "points are off by $(head -n 1 moved) to $(tail -n 1 moved) m"
}

property linear "harmonicBasis: a linear motion of the boundary needs few functions"
linear()
{
    makeSway fluid
    basis nFunctions 5
    basis fitLimit 1e-9
    runFluid
    expectText log.pimpleFoam "harmonicBasis: 5 functions for 30 boundary points"
    expectNoText log.pimpleFoam "harmonicBasis: 10 functions"
}

property doubling "harmonicBasis: where the functions fall short their number is doubled, up to all places"
doubling()
{
    makeSway fluid
    basis nFunctions 1
    basis fitLimit 0
    runFluid
    # The curve has 15 points; the extensions are solved for the last number alone
    expectText log.pimpleFoam "harmonicBasis: 1 functions" "harmonicBasis: 15 functions"
    expectNoText log.pimpleFoam "harmonicBasis: 2 functions"
    expectNoText log.pimpleFoam "the mesh moves as by displacementLaplacian"
    moved . | flapPoints 1 2 > moved
    expectSway 1 2 moved 30
}

property noPatch "harmonicBasis: patches that are not there are refused"
noPatch()
{
    makeSway fluid
    basis patches "(flag)"
    runFaultyFluid
    expectText log.pimpleFoam "no patch matches 'patches'" "flag" "dynamicMeshDict"
}

property misspelt "harmonicBasis: a misspelt entry is refused"
misspelt()
{
    makeSway fluid
    basis nFunction 5
    runFaultyFluid
    expectText log.pimpleFoam "unknown entry 'nFunction'; there are" "nFunctions"
}

property misspeltFallback "harmonicBasis: a fall-back that there is not is refused"
misspeltFallback()
{
    makeSway fluid
    basis fallback laplacian
    runFaultyFluid
    expectText log.pimpleFoam "unknown 'fallback' laplacian; there are: displacementLaplacian none" "dynamicMeshDict"
}

runProperties "$@"
