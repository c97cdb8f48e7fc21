#!/usr/bin/env bash
# An annulus that is slit at angle 0, clamped at one side of the slit and lifted at the other.
source "$(dirname "$0")/../structureScenes.sh"

property open "an annulus lifts at its slit where the case says slit"
open()
{
    makeScene annulus
    sed -i 's/^geometry:$/&\n  slit: yes/' slit.yaml
    runStructure slit.yaml
    # Full load of 0.8: 17.53 m at B (Sze, Liu & Lo 2004)
    expectClose "lift of B" "$(watch slit 6)" 17.53 0.01
}

runProperties "$@"
