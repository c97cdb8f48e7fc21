#!/usr/bin/env bash
# The structure's displacement arrives at the mesh points, whatever moves them: here
# OpenFOAM's displacementLaplacian, in testHarmonicBasis.sh ours.
source "$(dirname "$0")/harness.sh"

property plane "in 2D the points of both planes follow the structure, in any plane"
plane()
{
    local mesh
    for mesh in "plane 1 2" "xz 1 3" "yz 2 3"
    do
        set -- $mesh
        makeCase "$1" "$1"
        useLaplacian
        behave sway
        writeAtEnd
        runFluid
        movedPoints constant/polyMesh/points 0.03/polyMesh/points | flapPoints "$2" "$3" > moved
        # 15 points of the curve, on either plane
        expectSway "$2" "$3" moved 30
    done
}

property solid "in 3D the points of the surface follow the structure"
solid()
{
    makeCase fluid solid
    # The sway is along x, and proportional to y z
    useLaplacian
    behave sway
    writeAtEnd
    runFluid
    # At the foot nothing moves
    movedPoints constant/polyMesh/points 0.03/polyMesh/points \
        | flapPoints 1 2 | awk '$2 > 0' > moved
    expectSway 1 2 moved 39 3
}

property parallel "in parallel the points of each rank follow the structure"
parallel()
{
    local rank
    makeCase fluid
    useLaplacian
    behave sway
    writeAtEnd
    decompose 2
    runFluid 2
    for rank in 0 1
    do
        movedPoints processor$rank/constant/polyMesh/points processor$rank/0.03/polyMesh/points
    done | flapPoints 1 2 | sort -u > moved
    expectSway 1 2 moved 30
}

# motions: of the mesh, each with the outer corrector that it is in
motions()
{
    awk '
        /^PIMPLE: iteration/ { corrector = $3 }
        /^Time = / { time = $3; corrector = 1 }
        /Moving points for time/ { print time, corrector }' log.pimpleFoam
}

property still "the mesh is not moved to where it is: once less in a step, with the same result"
still()
{
    local type
    for type in dynamicMotionSolverFvMesh coupledMotionSolverFvMesh
    do
        cd "$propertyFolder"
        makeCase $type
        behave creeps
        writeAtEnd
        entry constant/dynamicMeshDict dynamicFvMesh $type
        entry system/controlDict DebugSwitches '{ polyMesh 1; }'
        runFluid
        motions > motions
    done
    cd "$propertyFolder"
    expectEqual "steps" "$(cut -d ' ' -f 1 coupled*/motions | sort -u | wc -l)" 3
    # Of each step all but the last
    expectEqual "motions" "$(cat coupled*/motions)" \
        "$(awk '{ if (NR > 1 && $1 == time) print line; time = $1; line = $0 }' dynamic*/motions)"
    # Points differ by rounding, which a time step of 0.01 s raises to 1e-14 m/s
    for type in dynamic coupled
    do
        finalForces ${type}MotionSolverFvMesh/record 0.03 > $type
    done
    expectSameTable "forces" 1e-9 dynamic coupled
}

property others "points of the other walls stay"
others()
{
    makeCase fluid
    useLaplacian
    behave sway
    writeAtEnd
    runFluid
    movedPoints constant/polyMesh/points 0.03/polyMesh/points > all
    awk '$1 == -3 || $1 == 3 || $2 == 4 || ($2 == 0 && $1^2 > 0.003) { print $4, $5, $6 }' all | sort -u > still
    expectEqual "displacements of the outer boundary" "$(cat still)" "0 0 0"
    awk '$1^2 > 0.0026 && $1 > -2.9 && $1 < 2.9 && $2 > 0.1 && $2 < 3.9 && $4 == 0' all > stuck
    expectEqual "points between that did not follow" "$(wc -l < stuck)" 0
}

property wallVelocity "the fluid at the flap has the velocity of the flap"
wallVelocity()
{
    makeCase fluid
    useLaplacian
    behave sway
    writeAtEnd
    runFluid
    pointField 0.03/U flap > velocity
    expectEqual "faces with a velocity" "$(wc -l < velocity)" 14
    sort -g velocity | tail -n 1 > fastest
    # The faces on the top go by the full sway, in their plane
    awk -v OFMT=%.15g 'BEGIN { print 0.05*(sin(20*0.03) - sin(20*0.02))/0.01, 0, 0 }' > expected
    # Displacements of 14 digits over a step of 0.01 s
    expectSameTable velocity 1e-10 expected fastest
}

runProperties "$@"
