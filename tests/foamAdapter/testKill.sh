#!/usr/bin/env bash
# Either process is killed at random moments of a run, and the run goes on from
# the last written time: its history is that of the uninterrupted run.
#
# TOKAY_KILLS=20 bash testKill.sh: so many moments for each process (2)
# TOKAY_KILL_SEED=N: those of an earlier run, which has printed N
source "$(dirname "$0")/harness.sh"

nKills=${TOKAY_KILLS:-2}
nSteps=40
writtenFiles="U Uf p phi meshPhi pointDisplacement polyMesh/points uniform/time uniform/harmonicBasis"

makeFluid()
{
    makeFlap "$1"
    entry system/controlDict endTime 0.4
    entry system/controlDict writeInterval 0.02
    entry system/controlDict writeFormat binary
    flapEntry 4e6 1e6
}

# history FOLDER: rows of the tip from all starts, the last start's where they overlap
history()
{
    local table
    for table in $(printf '%s\n' "$1"/structure/postProcessing/flap/*/watchPoints.dat \
        | awk -F / '{ print $(NF - 1), $0 }' | sort -g | cut -d ' ' -f 2)
    do
        grep -v '^#' "$table" || true
    done | awk '{ key = sprintf("%.6f", $1); row[key] = $0 } END { for (key in row) print row[key] }' | sort -g
}

# isWhole FOLDER: all its files were written to their end
isWhole()
{
    local file
    for file in $writtenFiles
    do
        tail -c 100 "$1/$file" 2> /dev/null | grep -q -a '^// \*\*\*\*' || return 1
    done
}

# removeIncomplete: what a user has to remove after the fluid was killed
removeIncomplete()
{
    local folder
    for folder in 0.*
    do
        if [ -d "$folder" ] && ! isWhole "$folder"
        then
            printf 'removed %s, which was not written to its end\n' "$folder"
            rm -r "$folder"
        fi
    done
}

# killAtRandom NAME: the process, anywhere in the first half of the run, so that it is there still
killAtRandom()
{
    local step=$((RANDOM % (nSteps / 2))) delay
    delay=$(printf '0.%03d' $((RANDOM % 50)))
    printf '%s: %s s after the beginning of step %s\n' "$1" "$delay" "$step"
    startFluid
    if [ "$step" -gt 0 ]
    then
        waitForText log.pimpleFoam "$(printf 'Time = %g' "$(awk -v n="$step" 'BEGIN { print n/100 }')")"
    else
        waitForText log.pimpleFoam "launched igaStructure"
    fi
    sleep "$delay"
    kill -KILL "$(processOf "$1")" || fail "$1 has ended before it could be killed"
    startTime=$SECONDS
    expectBadEnd
}

# killAndGoOn NAME: several times, and after each to the end
killAndGoOn()
{
    local moment seed=${TOKAY_KILL_SEED:-$RANDOM}
    RANDOM=$seed
    printf 'TOKAY_KILL_SEED=%s\n' "$seed"
    makeFluid whole
    runFluid
    cd ..
    history whole > whole.history
    expectEqual "steps" "$(wc -l < whole.history)" "$nSteps"
    for moment in $(seq "$nKills")
    do
        rm -rf "$propertyFolder/killed"
        makeFluid killed
        killAtRandom "$1"
        removeIncomplete
        entry system/controlDict startFrom latestTime
        runFluid
        cd ..
        history killed > killed.history
        # The table has twelve digits
        expectSameTable "tip after kill $moment" 1e-12 whole.history killed.history
        cmp -s whole/0.4/U killed/0.4/U || fail "the last velocity is another one after kill $moment"
    done
}

property fluid "a killed fluid goes on from its last written time as if nothing had happened"
fluid()
{
    killAndGoOn pimpleFoam
}

property structure "a killed structure goes on from the last written time as if nothing had happened"
structure()
{
    killAndGoOn igaStructure
}

runProperties "$@"
