#!/usr/bin/env bash
# Faults in mid-run with igaStructure: both sides end in time, and say why.
source "$(dirname "$0")/harness.sh"

# startLongRun [RANKS]: a run without an end, three steps old
startLongRun()
{
    makeFlap fluid
    entry system/controlDict endTime 1000
    entry system/controlDict writeInterval 1000
    if [ "${1:-1}" -gt 1 ]
    then
        decompose "$1"
    fi
    startFluid "$@"
    waitForText log.igaStructure "step 3"
    startTime=$SECONDS
}

property structureDies "a structure killed in mid-run is reported with its signal and its log"
structureDies()
{
    startLongRun
    kill -KILL "$(processOf igaStructure)"
    expectBadEnd
    expectOneMessage
    expectText log.pimpleFoam "the structure was ended by signal 9 (Killed); its log:" "log.igaStructure"
}

property fluidDies "a structure whose fluid is killed in mid-run ends, and says so"
fluidDies()
{
    startLongRun
    kill -KILL "$fluid"
    expectBadEnd
    expectText log.igaStructure "igaStructure: error: the fluid ended without saying why"
}

property structureTerminated "a structure that is terminated says so on both sides"
structureTerminated()
{
    startLongRun
    kill -TERM "$(processOf igaStructure)"
    expectBadEnd
    expectOneMessage
    expectText log.pimpleFoam "the structure ended: interrupted by signal 15 (Terminated)"
    expectText log.igaStructure "igaStructure: error: interrupted by signal 15 (Terminated)"
}

property interruption "Ctrl-C ends both sides, and both say so"
interruption()
{
    startLongRun
    kill -INT -- "-$fluid"
    expectBadEnd
    expectText log.pimpleFoam "interrupted"
    expectText log.igaStructure "interrupted"
}

property parallelInterruption "in parallel Ctrl-C ends both sides, and both say so"
parallelInterruption()
{
    # OpenMPI kills what has not ended after a second, which on a busy machine is
    # too soon for a last message
    export OMPI_MCA_odls_base_sigkill_timeout=3
    startLongRun 2
    kill -INT -- "-$fluid"
    expectBadEnd
    expectText log.pimpleFoam "structureCoupling: the run ends here: it was"
    expectText log.igaStructure "igaStructure: error: "
}

property silentFluid "a fluid that is silent is reported by the structure, and the run goes on"
silentFluid()
{
    makeFlap fluid
    coupling structure.arguments '("--silence-interval" "1")'
    entry system/controlDict endTime 1000
    entry system/controlDict writeInterval 1000
    startFluid
    waitForText log.igaStructure "step 3"
    kill -STOP "$fluid"
    waitForText log.igaStructure "since 1 s"
    local last
    last=$(grep '^step' log.igaStructure | tail -n 1 | awk '{ print $2 }')
    kill -CONT "$fluid"
    waitForText log.igaStructure "step $((last + 2))"
    expectText log.igaStructure "waiting for the fluid's"
    kill -TERM "$fluid"
    startTime=$SECONDS
    expectBadEnd
}

# Results of a good run, and their checksums
makeOlderResults()
{
    makeFlap fluid
    entry system/controlDict writeInterval 0.01
    runFluid
    find structure -type f ! -name case.yaml -exec sha256sum {} + | sort > older
    [ "$(grep -c '\.vtu$' older)" -eq 4 ] || fail "no older results"
}

expectOlderResults()
{
    sha256sum --check --quiet older || fail "older results have changed"
}

property diskFull "a full disk is told by both sides, and older results stay"
diskFull()
{
    makeOlderResults
    # A limit of the file size fails as a full disk does, where the signal is ignored
    cat > limited << 'END'
#!/bin/bash
trap '' XFSZ
ulimit -f 2
exec igaStructure "$@"
END
    chmod +x limited
    coupling structure.program "\"$PWD/limited\""
    runFaultyFluid
    expectText log.pimpleFoam "the structure ended: cannot write '" "File too large"
    expectText log.igaStructure "igaStructure: error: cannot write '" "File too large"
    expectOlderResults
}

property noResultsFolder "results that cannot be written are told by both sides, and older ones stay"
noResultsFolder()
{
    makeOlderResults
    # A file in the folder's place stops root too
    printf 'results:' > structure/inTheWay
    printf '  directory: inTheWay/results\n' > directory
    sed -i '/^output:/r directory' structure/case.yaml
    runFaultyFluid
    expectText log.pimpleFoam "the structure ended: cannot write '" "inTheWay"
    expectText log.igaStructure "igaStructure: error: cannot write '" "inTheWay"
    expectOlderResults
}

property readOnlyResults "a read-only results folder is told by both sides, and older results stay"
readOnlyResults()
{
    makeOlderResults
    chmod a-w structure/results structure/results/* 2> /dev/null
    if [ -w structure/results ]
    then
        return # root may write everywhere; noResultsFolder has shown the rest
    fi
    runFaultyFluid
    chmod u+w structure/results
    expectText log.pimpleFoam "the structure ended: cannot write '" "Permission denied"
    expectOlderResults
}

runProperties "$@"
