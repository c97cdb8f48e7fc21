#!/usr/bin/env bash
# An elastic roof of a channel moves towards its symmetry line. Right: the mesh
# slides along the line and is compressed evenly, as displacementLaplacian does it;
# the roof moves like those of the whole channel.
source "$(dirname "$0")/../scenes.sh"

# minVolume: of the cells at the last time
minVolume()
{
    checkMesh -latestTime > log.checkMesh 2>&1 || fail "checkMesh failed"
    sed -n 's/.*Min volume = \([^ ]*\)\. .*/\1/p' log.checkMesh | tail -n 1
}

property half "symmetry line: the mesh of half a channel is as good as displacementLaplacian's"
half()
{
    local type volume
    makeScene laplacian
    sed -i 's/^solver .*/solver displacementLaplacian;/; s/harmonicBasisCoeffs.*/displacementLaplacianCoeffs { diffusivity inverseDistance (roof); }/' \
        constant/dynamicMeshDict
    sed -i 's/minIter 20/minIter 60/' system/fvSolution
    runScene
    volume=$(minVolume)
    for type in symmetryPlane symmetry
    do
        makeScene $type
        sed -i "s/symmetryPlane/$type/" system/blockMeshDict 0/*
        runScene
        expectText log.pimpleFoam "extended in 2 ways for planes in which the mesh slides"
        # Five per cent: the diffusivities differ
        awk -v ours="$(minVolume)" -v theirs="$volume" 'BEGIN { exit !(ours >= 0.95*theirs) }' \
            || fail "smallest volume $(minVolume), displacementLaplacian's $volume"
        # Roof and symmetry line are 0.5 apart, and the fluid does little: the
        # structure alone moves by this
        movedPoints constant/polyMesh/points 0.2/polyMesh/points \
            | awk '$2 == 0 && $5^2 > 1e-20 { exit 1 }' || fail "points leave the symmetry line"
    done
}

property whole "symmetry line: the roof of half a channel moves like those of the whole one"
whole()
{
    makeScene half
    runScene
    makeWhole
    runScene
    # Coupling to 1e-5, and twice 32 functions in place of 32
    expectClose "middle of the upper roof" "$(watchPoint 0.2 2)" "$(cd ../../half/fluid && watchPoint 0.2 2)" 1e-4
}

# makeWhole: a roof and a floor, structures of their own
makeWhole()
{
    makeScene whole
    sed -i 's/(0 0 0) (2 0 0)/(0 -0.5 0) (2 -0.5 0)/; s/(0 0 1) (2 0 1)/(0 -0.5 1) (2 -0.5 1)/
        s/(40 20 1)/(40 40 1)/; s/axis { type symmetryPlane/floor { type wall/' system/blockMeshDict
    sed -i 's/axis.*/floor { type structureDisplacement; value uniform (0 0 0); }/' 0/pointDisplacement
    sed -i 's/axis.*/floor { type movingWallVelocity; value uniform (0 0 0); }/' 0/U
    sed -i 's/axis.*/floor { type zeroGradient; }/' 0/p
    sed -i 's/structure { tolerance/"structure|floor" { tolerance/' system/fvSolution
    sed -i 's|^functions {|functions { floor { type structureCoupling; patches (floor); rho 1e-4; structure { case "../floor/case.yaml"; } }|' \
        system/controlDict
    cp -r ../structure ../floor
    sed -i 's/name: roof/name: floor/; s/0\.5\]/-0.5]/g; s/"-1\.0/"1.0/' ../floor/case.yaml
}

runProperties "$@"
