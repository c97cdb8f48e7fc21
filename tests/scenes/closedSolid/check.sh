#!/usr/bin/env bash
# A pipe of 360 degrees under pressure, whose ends coincide.
source "$(dirname "$0")/../structureScenes.sh"

# Outwards motion of the side opposite to the seam against the seam, halved: Lame's
# radial displacement at the middle radius
property pipeAsSolid "a pipe of 360 degrees as solid is joined at its seam"
pipeAsSolid()
{
    makeScene pipe
    runStructure full_solid.yaml
    expectText log.igaStructure ", closed along xi"
    expectClose "radial displacement" "$(watch full_solid 2)" 0.000517 0.05
}

property pipeAsShell "a pipe of 360 degrees as shell is joined at its seam, and the log lists the joint"
pipeAsShell()
{
    makeScene pipe
    runStructure full_shell.yaml
    expectText log.igaStructure "joined where edges coincide"
    expectClose "radial displacement" "$(watch full_shell 4 | tr -d -)" 0.000499 0.01
}

runProperties "$@"
