#!/usr/bin/env bash
# A cylinder whose cad.json has one closed patch and no edges.
source "$(dirname "$0")/../structureScenes.sh"

property seam "a closed patch of a cad.json without edges is joined at its seam"
seam()
{
    makeScene cylinder
    runStructure cylNoEdges.yaml
    expectText log.igaStructure "with 1 joint"
    # p R^2 / (E t)
    expectClose "radial displacement" "$(watch cylNoEdges 1)" 1e-3 0.02
}

runProperties "$@"
