#!/usr/bin/env bash
# The interface that the structure is told: a curve in 2D, a surface in 3D.
source "$(dirname "$0")/harness.sh"

# The flap has 6 + 2 + 6 faces around it
property plane "a 2D mesh is sent as a curve with each point and each edge once"
plane()
{
    makeCase fluid
    runFluid
    expectEqual dimension "$(recordRow record dimension)" 2
    interfacePoints record > points
    expectEqual "number of points" "$(sort -u points | wc -l)/$(wc -l < points)" 15/15
    interfaceFaces record > faces
    expectEqual "number of edges" "$(sort -u faces | wc -l)/$(wc -l < faces)" 14/14
    expectEqual "points an edge" "$(cut -d ' ' -f 1 faces | sort -u)" 2

    # Tip and foot of the flap, and an edge's centre on its top
    grep -q '^-0.050000000 0.000000000$' points || fail "no point at the foot"
    grep -q '^0.050000000 1.000000000$' points || fail "no point at the tip"
    grep -q '^2 -0.025000000 1.000000000 ' faces || fail "no edge on the top"
    expectEqual "displacements" "$(recordRow record displacements | sort -u)" 0
    expectEqual "tolerance" "$(recordRow record tolerance)" 0.0001
}

property thickness "forces of a 2D mesh are per unit depth, whatever its thickness"
thickness()
{
    makeCase thick
    runFluid
    makeCase thin thin
    runFluid
    cd ..
    finalForces thick/record 0.03 > thick.forces
    finalForces thin/record 0.03 > thin.forces
    # The linear solvers stop at 1e-8 of residuals that scale with the mesh
    expectSameTable forces 1e-6 thick.forces thin.forces
}

property otherPlanes "a 2D mesh in the x-z or y-z plane gives the curve and the forces of the x-y plane"
otherPlanes()
{
    makeCase xy
    runFluid
    makeCase xz xz
    runFluid
    makeCase yz yz
    runFluid
    cd ..
    for plane in xy xz yz
    do
        interfacePoints $plane/record > $plane.points
        finalForces $plane/record 0.03 > $plane.forces
    done
    for plane in xz yz
    do
        expectSameTable points 1e-9 xy.points $plane.points
        # Rounding of turned coordinates, through the linear solvers' tolerance
        expectSameTable forces 1e-6 xy.forces $plane.forces
    done
}

property solid "a 3D mesh is sent as a surface with each point and each face once"
solid()
{
    makeCase fluid solid
    runFluid
    expectEqual dimension "$(recordRow record dimension)" 3
    interfacePoints record > points
    expectEqual "number of points" "$(sort -u points | wc -l)/$(wc -l < points)" 45/45
    interfaceFaces record > faces
    expectEqual "number of faces" "$(sort -u faces | wc -l)/$(wc -l < faces)" 28/28
    expectEqual "points a face" "$(cut -d ' ' -f 1 faces | sort -u)" 4
}

property planeFlow "a plane flow has the same force per unit depth in a 3D mesh as in a 2D mesh"
planeFlow()
{
    makeCase plane
    manyCorrectors # as the 3D mesh has them
    tightenSolvers
    runFluid
    makeCase slab slab
    tightenSolvers
    runFluid
    cd ..
    forceSum plane/record 0.03 > plane.sum
    forceSum slab/record 0.03 > slab.sum
    # The same equations, solved to residuals of 1e-11
    expectSameTable force 1e-9 plane.sum slab.sum
}

property patches "several patches in one interface are the interface of one patch with all faces"
patches()
{
    makeCase one
    runFluid
    makeCase several
    splitFlap
    coupling patches '("flap.*" flapTop)'
    runFluid
    cd ..
    for case in one several
    do
        interfacePoints $case/record > $case.points
        finalForces $case/record 0.03 > $case.forces
    done
    expectSameTable points 1e-12 one.points several.points
    # The same equations with boundary faces in another order
    expectSameTable forces 1e-7 one.forces several.forces
}

# The flap's patch in three: sides, top
splitFlap()
{
    sed -i 's/flap { type wall ; faces ( ( 1 5 17 13 ) ( 5 6 18 17 ) ( 2 14 18 6 ) ) ; }/flapLeft { type wall ; faces ( ( 1 5 17 13 ) ) ; } flapTop { type wall ; faces ( ( 5 6 18 17 ) ) ; } flapRight { type wall ; faces ( ( 2 14 18 6 ) ) ; }/' \
        system/blockMeshDict
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    sed -i 's/^    flap$/    "flap.*"/; s/(inlet|flap|/(inlet|flap.*|/' 0/p 0/U 0/pointDisplacement
}

property deformedStart "a start from a deformed mesh sends the undeformed points and the displacement"
deformedStart()
{
    makeCase fluid
    behave sway
    entry system/controlDict writeInterval 0.03
    runFluid
    mv record first.record
    entry system/controlDict startFrom latestTime
    entry system/controlDict endTime 0.04
    runFluid
    interfacePoints first.record > first.points
    interfacePoints record > points
    # 14 digits in the files
    expectSameTable points 1e-12 first.points points

    recordRow record displacements > displacements
    awk '$1 == "answer" && $2 == 0.03 { for (i = 4; i <= NF; ++i) print $i > "answers" }' first.record
    tail -n 30 answers > last
    expectSameTable displacements 1e-12 last displacements
    expectEqual "number of the first step" "$(awk '$1 == "step" { print $2; exit }' record)" 1
    expectEqual "start of the run" "$(recordRow record times | head -n 1)" 0.03
}

runProperties "$@"
