#!/usr/bin/env bash
# A flap before which some of the fluid's cells are refined, so that faces have hanging
# nodes: corners that lie in the middle of a neighbour's edge. Shared out by corners, the
# force of such a face acts beside its middle, and the moment is 2 % off. Right: to rounding.
source "$(dirname "$0")/../scenes.sh"

property moment "hanging nodes: the moment arrives to rounding, and while the flap bends to what its faces bend"
moment()
{
    makeScene fluid
    entry system/controlDict endTime 0.02
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    topoSet > log.topoSet 2>&1 || fail "topoSet failed"
    refineHexMesh c0 -overwrite > log.refineHexMesh 2>&1 || fail "refineHexMesh failed"
    rm -f 0/cellLevel 0/pointLevel 0/level0Edge 0/surfaceIndex
    runFluid
    # The mapping measures itself in the reference configuration
    awk '/errors: constant/ { n++; if ($NF > 1e-12) bad = $NF }
        END { if (n != 2 || bad) { print "moment off by " bad; exit 1 } }' ../structure/log.igaStructure ||
        fail "the mapping changes the moment"
    # A face that bends has its middle elsewhere than the shell: by the square of the face's
    # size times the curvature over 24, 1e-5 of the flap's height
    awk '!/^#/ && ($18 > 1e-12 || $19 > 2e-5) { print; bad = 1 } END { exit bad }' \
        postProcessing/structure/0/conservation.dat || fail "force or moment is lost"
}

runProperties "$@"
