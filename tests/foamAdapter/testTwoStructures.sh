#!/usr/bin/env bash
# More than one structure in one fluid, or more than one patch: the flap and its mirror image at the
# opposite wall of a channel twice as high. Each moves as the flap below a wall
# without friction at half the height, a plane of symmetry.
source "$(dirname "$0")/harness.sh"

# makeTwoFlaps FOLDER: the second is the patch, function object and structure "top"
makeTwoFlaps()
{
    makeFlap "$1"
    removeEntry system/controlDict functions.structure.structure.log
    allFunctions
    mirrorChannel
    split "(-1 4 -1) (1 9 2)"
    mirrorStructure
    foamDictionary -disableFunctionEntries system/controlDict -entry functions.top -set \
        '{ type structureCoupling; patches (top); rho 1; structure { case "structure/top.yaml"; } }' > log.foamDictionary 2>&1
    entry system/fvSolution PIMPLE.residualControl.top '{ tolerance 1e-6; relTol 0; }'
    entry system/fvSolution PIMPLE.residualControl.structure.tolerance 1e-6
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-6
}

# One function of the mesh motion a place: as symmetric as the mesh
allFunctions()
{
    entry constant/dynamicMeshDict harmonicBasisCoeffs '{ nFunctions 1000; }'
}

mirrorChannel()
{
    cat > system/mirrorMeshDict << END
FoamFile { version 2.0; format ascii; class dictionary; object mirrorMeshDict; }
planeType           pointAndNormal;
pointAndNormalDict  { point (0 4 0); normal (0 -1 0); }
planeTolerance      1e-4;
END
    mirrorMesh -overwrite > log.mirrorMesh 2>&1 || fail "mirrorMesh failed"
}

# split BOX: what the box has of the patch "flap" becomes the patch "top"
split()
{
    local field
    cat > system/topoSetDict << END
FoamFile { version 2.0; format ascii; class dictionary; object topoSetDict; }
actions
(
    { name top; type faceSet; action new; source patchToFace; sourceInfo { name flap; patch flap; } }
    { name top; type faceSet; action subset; source boxToFace; sourceInfo { box $1; } }
);
END
    cat > system/createPatchDict << END
FoamFile { version 2.0; format ascii; class dictionary; object createPatchDict; }
pointSync false;
patches ( { name top; patchInfo { type wall; } constructFrom set; set top; } );
END
    topoSet > log.topoSet 2>&1 || fail "topoSet failed"
    createPatch -overwrite > log.createPatch 2>&1 || fail "createPatch failed"
    for field in U p pointDisplacement
    do
        entry 0/$field boundaryField.top "$(foamDictionary 0/$field -entry boundaryField.flap | sed '1d')"
    done
}

mirrorStructure()
{
    sed 's/^name: flap/name: top/; s/origin: \[-0.05, 0\]/origin: [-0.05, 7]/; s/edge: bottom/edge: top/
        s/interface: \[left, top, right\]/interface: [left, bottom, right]/; s/at: \[0, 1\]/at: [0, 7]/' \
        structure/case.yaml > structure/top.yaml
}

# tip NAME: "time ux uy" of a step a row
tip()
{
    grep -v '^#' "structure/postProcessing/$1/0/watchPoints.dat"
}

property mirrored "two flaps that face each other move as one below a plane of symmetry"
mirrored()
{
    makeTwoFlaps two
    runFluid
    tip flap > ../flap
    tip top | awk '{ print $1, $2, -$3 }' > ../top
    expectText log.pimpleFoam "structureCoupling structure:" "structureCoupling top:"
    expectText structure/log.igaStructure "step 3"
    expectText structure/log.igaStructure.top "step 3"
    cd ..
    makeFlap one
    allFunctions
    sed -i 's/^    outlet/    upperWall { type slip; }\n    outlet/' 0/U
    entry system/fvSolution PIMPLE.residualControl.structure.tolerance 1e-6
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-6
    runFluid
    tip flap > ../single
    cd ..
    expectEqual "steps" "$(wc -l < single)" 3
    # Steps converged to 1e-6 each; tables of a millionth of the tip's motion
    expectSameTable "flap below the plane" 2e-5 single flap
    expectSameTable "its mirror image" 2e-5 single top
}

property tables "each structure has tables and a residual of its own"
tables()
{
    makeTwoFlaps two
    runFluid
    local name
    for name in structure top
    do
        expectEqual "converged steps of $name" \
            "$(grep -v '^#' postProcessing/$name/0/coupling.dat | awk '$7 == 1 && $5 < 1e-6' | wc -l)" 3
        expectEqual "audited steps of $name" "$(grep -vc '^#' postProcessing/$name/0/conservation.dat)" 3
    done
}

property parallel "on two ranks they move as on one"
parallel()
{
    local case
    for case in serial parallel
    do
        makeTwoFlaps $case
        if [ $case = parallel ]
        then
            decompose 2
            runFluid 2
        else
            runFluid
        fi
        tip flap > ../$case.flap
        tip top > ../$case.top
        cd ..
    done
    # Steps converged to 1e-6 each
    expectSameTable "flap" 2e-5 serial.flap parallel.flap
    expectSameTable "top" 2e-5 serial.top parallel.top
}

property control "each needs an entry of residualControl"
control()
{
    makeTwoFlaps two
    removeEntry system/fvSolution PIMPLE.residualControl.top
    runFaultyFluid
    expectText log.pimpleFoam "residualControl has no entry 'top'"
    expectText structure/log.igaStructure "the fluid ended"
}

property sameLog "the two must not share a log"
sameLog()
{
    makeTwoFlaps two
    coupling structure.log '"structure/log"'
    entry system/controlDict functions.top.structure.log '"structure/log"'
    runFaultyFluid
    expectText log.pimpleFoam "is that of another structure: choose another 'log'"
}

property failure "the failure of one ends the fluid and the other"
failure()
{
    makeTwoFlaps two
    entry system/controlDict endTime 100
    startFluid
    waitForText structure/log.igaStructure.top "step 1"
    local pid
    pid=$(processOf igaStructure)
    kill -KILL "$pid"
    expectBadEnd
    expectOneMessage
    expectText log.pimpleFoam "the structure was ended by signal 9"
    cat structure/log.igaStructure structure/log.igaStructure.top > logs
    expectText logs "the fluid ended"
}

property patches "one structure that touches two patches moves as on one"
patches()
{
    local case
    for case in one two
    do
        makeFlap $case
        allFunctions
        entry system/fvSolution PIMPLE.residualControl.structure.tolerance 1e-6
        entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-6
        if [ $case = two ]
        then
            # The left side
            split "(-1 -1 -1) (-0.04 2 2)"
            coupling patches "(flap top)"
        fi
        runFluid
        tip flap > ../$case.tip
        cd ..
    done
    expectText two/log.pimpleFoam "15 points"
    # Steps converged to 1e-6 each
    expectSameTable "tip" 2e-5 one.tip two.tip
}

runProperties "$@"
