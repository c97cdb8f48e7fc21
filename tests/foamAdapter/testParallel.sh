#!/usr/bin/env bash
# Any number of ranks gives the same interface and the same forces.
source "$(dirname "$0")/harness.sh"

# prepare FOLDER MESH
prepare()
{
    makeCase "$1" "$2"
    tightenSolvers
    behave sway
    # Distances from a patch, which other diffusivities take, depend on the ranks
    entry constant/dynamicMeshDict harmonicBasisCoeffs.diffusivity uniform
}

# compareWithSerial RANKS [MESH]
compareWithSerial()
{
    local case
    prepare serial "${2:-plane}"
    runFluid
    prepare parallel "${2:-plane}"
    decompose "$1"
    runFluid "$1"
    cd ..
    for case in serial parallel
    do
        interfacePoints $case/record > $case.points
        interfaceFaces $case/record > $case.faces
        finalForces $case/record 0.03 > $case.forces
    done
    cmp -s serial.points parallel.points || fail "the points are not those of the serial run"
    cmp -s serial.faces parallel.faces || fail "the faces are not those of the serial run"
    # Linear solvers that stop at 1e-11 of residual norms, of matrices with a
    # condition of some 1e3
    expectSameTable forces 1e-7 serial.forces parallel.forces
}

# facesOfRanks: number of the flap's faces on each rank
facesOfRanks()
{
    local boundary
    for boundary in parallel/processor*/constant/polyMesh/boundary
    do
        awk '$1 == "flap" { inside = 1 } inside && $1 == "nFaces" { print $2 + 0; exit }' "$boundary"
    done | tr '\n' ' '
}

# expectGatherTimed: a part of what forces and structure take, in each time step
expectGatherTimed()
{
    awk '
        /time\[s\]/ { for (i = 2; i <= NF; i++) column[$i] = i - 1; isThere = "gather[s]" in column }
        /^#/ { next }
        { n++; gather = $column["gather[s]"] }
        !(gather > 0 && gather <= $column["force[s]"] + $column["structure[s]"]) { wrong = 1 }
        END { exit !(n && isThere && !wrong) }' parallel/postProcessing/structure/0/coupling.dat \
        || fail "gather[s] is not a part of force[s] and structure[s]"
}

property twoRanks "two ranks that share the interface give the points, faces and forces of one"
twoRanks()
{
    compareWithSerial 2
    [[ " $(facesOfRanks)" != *" 0 "* ]] || fail "the ranks do not share the interface: $(facesOfRanks)"
    expectGatherTimed
}

property emptyRank "ranks without an interface face take part"
emptyRank()
{
    compareWithSerial 3
    [[ " $(facesOfRanks)" == *" 0 "* ]] || fail "all ranks have faces: $(facesOfRanks)"
}

property solid "two ranks give the points, faces and forces of one in 3D"
solid()
{
    compareWithSerial 2 solid
    [[ " $(facesOfRanks)" != *" 0 "* ]] || fail "the ranks do not share the interface: $(facesOfRanks)"
}

runProperties "$@"
