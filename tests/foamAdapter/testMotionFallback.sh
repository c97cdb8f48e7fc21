#!/usr/bin/env bash
# Where the mesh cannot be a product, the motion solver harmonicBasis moves it as
# displacementLaplacian does, says why, and the run goes on; or stops if the case
# says so.
source "$(dirname "$0")/harness.sh"

message="the mesh moves as by displacementLaplacian with 60 sweeps from here on, because"

# makeSway FOLDER [MESH]: fakeStructure's sway
makeSway()
{
    makeCase "$@"
    behave sway
    writeAtEnd
}

# basis KEY VALUE: sets an entry of the motion solver
basis()
{
    entry constant/dynamicMeshDict "harmonicBasisCoeffs.$1" "$2"
}

# expectFallback REASON...: said once, with its reason
expectFallback()
{
    expectText log.pimpleFoam "$message"
    expectEqual "fall-backs" "$(grep -c 'harmonicBasis: the mesh moves' log.pimpleFoam)" 1
    expectText log.pimpleFoam "$@"
}

# expectFollowing TIME: the flap goes where the structure says, the other walls
# stay, points between follow
expectFollowing()
{
    movedPoints constant/polyMesh/points "$1/polyMesh/points" > all
    flapPoints 1 2 < all > moved
    expectSway 1 2 moved 30
    awk '$1 == -3 || $1 == 3 || $2 == 4 || ($2 == 0 && $1^2 > 0.003) { print $4, $5, $6 }' all | sort -u > still
    expectEqual "displacements of the outer boundary" "$(cat still)" "0 0 0"
    awk '$1^2 > 0.0026 && $1 > -2.9 && $1 < 2.9 && $2 > 0.1 && $2 < 3.9 && $4 == 0' all > stuck
    expectEqual "points between that did not follow" "$(wc -l < stuck)" 0
}

# expectRefused REASON...: with 'fallback none' the same run stops
expectRefused()
{
    basis fallback none
    rm -rf 0.0*
    runFaultyFluid
    expectText log.pimpleFoam "harmonicBasis cannot move the mesh, because" "$@" \
        "With 'fallback displacementLaplacian' the run would go on" "dynamicMeshDict"
}

property memory "motion fall-back: functions beyond the memory limit"
memory()
{
    makeSway fluid
    basis memoryLimit 0.001
    runFluid
    expectFallback "30 functions can take" "more than the 'memoryLimit' of 0.001; more ranks need less"
    expectFollowing 0.03
    expectRefused "more than the 'memoryLimit' of 0.001"
}

property doubling "motion fall-back: functions that fall short, where twice as many are beyond the memory limit"
doubling()
{
    makeSway fluid
    basis nFunctions 1
    basis fitLimit 0
    basis memoryLimit 0.015
    runFluid
    expectText log.pimpleFoam "harmonicBasis: 1 functions"
    expectFallback "4 functions miss the boundary's motion by" "'fitLimit' allows 0 m, and 8 functions can take"
    expectFollowing 0.03
    expectRefused "4 functions miss the boundary's motion by" "8 functions can take"
}

property otherPatch "motion fall-back: a motion of other patches"
otherPatch()
{
    makeSway fluid
    basis patches "(upperWall)"
    runFluid
    expectFallback "patches that are not among 'patches' (upperWall) move: flap"
    expectFollowing 0.03
    expectRefused "patches that are not among 'patches' (upperWall) move: flap"
}

property laplacian "motion fall-back: the mesh is that of a converged displacementLaplacian"
laplacian()
{
    makeSway fallback
    basis memoryLimit 0.001
    basis fallbackSweeps 300
    basis diffusivity 'quadratic inverseDistance (flap)'
    runFluid
    expectText log.pimpleFoam "displacementLaplacian with 300 sweeps"
    movedPoints constant/polyMesh/points 0.03/polyMesh/points | awk '{ print $4, $5 }' > ../fallback.moved
    cp -r . ../laplacian
    cd ../laplacian
    rm -rf 0.03 postProcessing
    useLaplacian
    runFluid
    movedPoints constant/polyMesh/points 0.03/polyMesh/points | awk '{ print $4, $5 }' > moved
    # The limit of the diffusivity at the boundary makes a difference within the
    # first cells
    expectSameTable displacement 0.02 ../fallback.moved moved
}

property parallel "motion fall-back: on two ranks, of which one has the flap's larger part"
parallel()
{
    local rank
    makeSway fluid
    basis patches "(upperWall)"
    decompose 2
    runFluid 2
    expectFallback "patches that are not among 'patches' (upperWall) move: flap"
    for rank in 0 1
    do
        movedPoints processor$rank/constant/polyMesh/points processor$rank/0.03/polyMesh/points
    done | flapPoints 1 2 | sort -u > moved
    expectSway 1 2 moved 30
}

# makeMotion FOLDER: the mesh alone, whose flap is displaced by (0.02 0.01 0)
makeMotion()
{
    makeCase "$1"
    entry system/controlDict functions '{}'
    entry system/controlDict deltaT 0.01
    writeAtEnd
    sed -i 's/structureDisplacement;/fixedValue;/; s/uniform (0 0 0);/uniform (0.02 0.01 0);/;
        /inlet|outlet/,/}/ s/0.02 0.01/0 0/; s/^\(internalField *\).*/\1uniform (0 0 0);/' 0/pointDisplacement
    basis patches "(flap)"
    solver=moveDynamicMesh
}

# expectDisplaced: the flap's points but those that the wall at its foot holds
expectDisplaced()
{
    movedPoints constant/polyMesh/points 0.03/polyMesh/points \
        | flapPoints 1 2 | awk '$2 > 0 { printf "%.9f %.9f %.9f\n", $4, $5, $6 }' | sort -u > moved
    expectEqual "displacement of the flap" "$(cat moved)" "0.020000000 0.010000000 0.000000000"
}

property ami "motion fall-back: a cyclicAMI"
ami()
{
    makeMotion fluid
    sed -i '/^    inlet/,/}/ s/patch;/cyclicAMI; neighbourPatch outlet; transform translational; separationVector (6 0 0);/
        /^    outlet/,/}/ s/patch;/cyclicAMI; neighbourPatch inlet; transform translational; separationVector (-6 0 0);/' constant/polyMesh/boundary
    sed -i 's/"(inlet|outlet|/"(inlet|outlet)" { type cyclicAMI; }\n    "(/' 0/pointDisplacement
    runFluid
    expectFallback "patch 'inlet' is a cyclicAMI"
    expectDisplaced
    expectRefused "patch 'inlet' is a cyclicAMI"
}

# makeFaceZone BOX: named inside, of the faces in a box
makeFaceZone()
{
    cat > system/topoSetDict << END
FoamFile { version 2.0; format ascii; class dictionary; object topoSetDict; }
actions
(
    { name inside; type faceSet; action new; source boxToFace; box $1; }
    { name inside; type faceZoneSet; action new; source setToFaceZone; faceSet inside; }
);
END
    topoSet > log.topoSet 2>&1 || fail "topoSet failed"
}

property topology "motion fall-back: a change of topology"
topology()
{
    makeMotion fluid
    # Beyond its largest thickness a layer of cells is divided, and so are its halves
    makeFaceZone "(-2.42 -1 -1) (-2.41 5 5)"
    cat > constant/polyMesh/meshModifiers << END
FoamFile { version 2.0; format ascii; class polyTopoChanger; object meshModifiers; }
1
(
    layer
    {
        type layerAdditionRemoval; faceZoneName inside; active yes;
        minLayerThickness 0.01; maxLayerThickness 0.4; oldLayerThickness -1;
    }
)
END
    entry constant/dynamicMeshDict dynamicFvMesh dynamicMotionSolverTopoFvMesh
    entry constant/dynamicMeshDict dynamicFvMeshLibs '("libtopoChangerFvMesh.so")'
    runFluid
    expectText log.pimpleFoam "harmonicBasis: 15 functions"
    expectFallback "the topology of the mesh has changed"
    # Numbers of points have changed, so the flap is known by its upper corners
    expectEqual "displaced corners" "$(grep -c '^(-*0\.0[37]0*[0-9]* 1\.01[0 ]' 0.03/polyMesh/points)" 4
    expectRefused "the topology of the mesh has changed"
}

property fit "motion fall-back: two sides of a baffle that move apart"
fit()
{
    makeMotion fluid
    makeFaceZone "(-1.6 2.3 -1) (1.6 2.4 5)"
    cat > system/createBafflesDict << END
FoamFile { version 2.0; format ascii; class dictionary; object createBafflesDict; }
internalFacesOnly true;
baffles
{
    plate
    {
        type faceZone; zoneName inside;
        patches
        {
            master { name below; type wall; }
            slave { name above; type wall; }
        }
    }
}
END
    createBaffles -overwrite > log.createBaffles 2>&1 || fail "createBaffles failed"
    mergeOrSplitBaffles -split -overwrite > log.mergeOrSplitBaffles 2>&1 || fail "mergeOrSplitBaffles failed"
    basis patches '("(flap|below|above)")'
    entry 0/pointDisplacement boundaryField.below '{ type fixedValue; value uniform (0 0 0); }'
    entry 0/pointDisplacement boundaryField.above '{ type fixedValue; value uniform (0 0.02 0); }'
    runFluid
    expectFallback "functions miss the boundary's motion by" "there is one for each point of the boundary"
    movedPoints constant/polyMesh/points 0.03/polyMesh/points | awk '$2 > 2.3 && $2 < 2.4 { printf "%.9f\n", $5 }' > plate
    expectEqual "points of the upper side" "$(grep -c 0.020000000 plate)" "$(grep -c '^0.000000000' plate)"
    expectRefused "there is one for each point of the boundary"
}

runProperties "$@"
