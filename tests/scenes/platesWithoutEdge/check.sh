#!/usr/bin/env bash
# Two plates side by side whose cad.json does not share their edge.
source "$(dirname "$0")/../structureScenes.sh"

property joined "plates whose edges coincide are joined, and the log lists the joint"
joined()
{
    makeScene plates
    runStructure ne.yaml
    expectText log.igaStructure "joined where edges coincide (geometry.slit: yes keeps them open): 1.1-2.3"
}

property loose "a plate that nothing supports or joins stops check and run"
loose()
{
    makeScene plates
    sed -i 's/^geometry: {/&slit: yes, /' ne.yaml
    expectRefused check ne.yaml "nothing supports or joins: patch 2"
    expectRefused run ne.yaml "nothing supports or joins: patch 2"
}

runProperties "$@"
