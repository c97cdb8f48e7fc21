#!/usr/bin/env bash
# The free end of a roof moves along an outlet whose points may slide, by more than a
# cell. Right: they slide, and the mesh is as good as displacementLaplacian's.
source "$(dirname "$0")/../scenes.sh"

property slides "slip outlet: its points follow the end of the roof, in their plane"
slides()
{
    makeScene fluid
    runScene
    movedPoints constant/polyMesh/points 0.2/polyMesh/points | awk '$1 == 2 && $3 == 0' | sort -k 2g > outlet
    expectEqual "points of the outlet" "$(wc -l < outlet)" 21
    # The extensions are solved to 1e-7 of the motion, which is 0.05 m here
    awk '$4^2 > 1e-16 { exit 1 }' outlet || fail "points leave the outlet's plane"
    # From the wall, which is fixed, to the roof's end each goes farther than the
    # one before
    awk 'NR > 1 && !($5 < before) { exit 1 } { before = $5 }' outlet || fail "the outlet does not slide"
    awk 'END { exit !($5 < -0.025) }' outlet || fail "the roof's end has not moved by a cell"
}

runProperties "$@"
