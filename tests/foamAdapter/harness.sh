# Usage: source harness.sh
#
# What the adapter's tests share. A test script is a list of properties,
#
#     property plane "a 2D mesh is sent as a curve"
#     plane() { makeCase fluid; runFluid; expect...; }
#     runProperties "$@"
#
# each a function and the sentence under which CTest lists it. `testX.sh` runs
# them all, `testX.sh plane` runs one, in a folder of its own below the build
# folder, where its cases and logs stay until the next run.

set -euo pipefail
testsFolder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$testsFolder/../../bin/environment"
# A build of the core alone, such as one with sanitizers, takes the release's adapter
if [ ! -f "$FOAM_USER_LIBBIN/libtokayFoamAdapter.so" ]
then
    export FOAM_USER_LIBBIN=$TOKAY_ROOT/build/release/foam
    export LD_LIBRARY_PATH=$FOAM_USER_LIBBIN:$LD_LIBRARY_PATH
fi
if [ ! -f "$FOAM_USER_LIBBIN/libtokayFoamAdapter.so" ]
then
    printf 'the adapter is not built: run ./Allwmake\n' >&2
    exit 1
fi
source "$testsFolder/cases.sh"
source "$testsFolder/tables.sh"

runsFolder=${TOKAY_TEST_FOLDER:-$TOKAY_BUILD/tests/foamAdapter/runs}
scriptName=$(basename "$0" .sh)
export PATH=$TOKAY_BUILD/bin:$PATH

#- Its log is log.pimpleFoam in any case
solver=pimpleFoam

#- Seconds that a run with a fault may take to its end
faultLimit=10

propertyNames=()
propertySentences=()

# property NAME SENTENCE: names the function that follows
property()
{
    propertyNames+=("$1")
    propertySentences+=("$2")
}

# runProperties [NAME...]: all, or those named
runProperties()
{
    local i ran=0 failed=0
    if [ -n "${TOKAY_TEST_INNER:-}" ]
    then
        unset TOKAY_TEST_INNER
        runProperty "$1"
        return
    fi
    for i in "${!propertyNames[@]}"
    do
        [ $# -eq 0 ] || [[ " $* " == *" ${propertyNames[i]} "* ]] || continue
        ran=$((ran + 1))
        # In a shell of its own, where the first failing command ends it
        if TOKAY_TEST_INNER=yes bash "$0" "${propertyNames[i]}"
        then
            printf 'passed  %s\n' "${propertySentences[i]}"
        else
            printf 'FAILED  %s\n' "${propertySentences[i]}"
            failed=$((failed + 1))
        fi
    done
    [ "$ran" -gt 0 ] && [ "$failed" -eq 0 ]
}

runProperty()
{
    propertyFolder=$runsFolder/$scriptName/$1
    # Its own processes, and theirs, are known by this in their environment
    mark=TOKAY_TEST_MARK=$1.$$.$(date +%s%N)
    rm -rf "$propertyFolder"
    mkdir -p "$propertyFolder"
    cd "$propertyFolder"
    trap endProcesses EXIT
    "$1"
}

# fail TEXT...: ends the property, with the ends of the logs
fail()
{
    local log
    printf '%s: %s\n' "$(basename "$PWD")" "$*" >&2
    for log in log.pimpleFoam log.igaStructure
    do
        if [ -f "$log" ]
        then
            printf -- '--- end of %s\n' "$PWD/$log" >&2
            tail -n 25 "$log" >&2
        fi
    done
    exit 1
}

# Process numbers of what this property has started and is still there
processes()
{
    # Others' processes cannot be read, and some are gone when it is their turn
    { grep --files-with-matches --no-messages --text --fixed-strings "$mark" \
        /proc/[0-9]*/environ || true; } | sed 's|/proc/\([0-9]*\)/.*|\1|'
}

# processOf NAME: number of this property's first process of that program
processOf()
{
    local pid
    for pid in $(processes)
    do
        if [ "$(cat "/proc/$pid/comm" 2> /dev/null)" = "$1" ]
        then
            printf '%s\n' "$pid"
            return
        fi
    done
    fail "no process $1"
}

endProcesses()
{
    local pid
    for pid in $(processes)
    do
        kill -KILL "$pid" 2> /dev/null || true
    done
}

# fluidCommand [RANKS]: sets the command that runs the case
fluidCommand()
{
    command=("$solver")
    if [ "${1:-1}" -gt 1 ]
    then
        command=(mpirun --oversubscribe -np "$1" "$solver" -parallel)
    fi
}

# runFluid [RANKS]: the case from start to a good end
runFluid()
{
    local status=0
    fluidCommand "$@"
    env "$mark" timeout 60 "${command[@]}" > log.pimpleFoam 2>&1 || status=$?
    [ "$status" -eq 0 ] || fail "the run has ended with status $status"
    expectNoProcess 5
}

# runFaultyFluid [RANKS]: the case to an end that is not good, in time
runFaultyFluid()
{
    startFluid "$@"
    expectBadEnd
    [ "${1:-1}" -gt 1 ] || expectOneMessage
}

# startFluid [RANKS]: the case in a process group of its own, as a terminal
# would have it; sets fluid to its process number
startFluid()
{
    fluidCommand "$@"
    startTime=$SECONDS
    set -m
    env "$mark" "${command[@]}" > log.pimpleFoam 2>&1 &
    set +m
    fluid=$!
}

# The fluid ends within the limit, not with status 0, and nothing is left
expectBadEnd()
{
    local status=0
    while kill -0 "$fluid" 2> /dev/null
    do
        [ $((SECONDS - startTime)) -le $faultLimit ] \
            || fail "no end within $faultLimit s"
        sleep 0.05
    done
    wait "$fluid" 2> /dev/null || status=$?
    [ "$status" -ne 0 ] || fail "the run has ended with status 0"
    expectNoProcess $((faultLimit - (SECONDS - startTime) + 1))
}

# expectNoProcess SECONDS: none of this property's processes after so long
expectNoProcess()
{
    local deadline=$((SECONDS + $1)) left
    while left=$(processes) && [ -n "$left" ]
    do
        [ "$SECONDS" -lt "$deadline" ] \
            || fail "processes are left: $(ps -o pid=,args= -p "$(tr '\n' ',' <<< "${left}")0")"
        sleep 0.05
    done
}

# expectOneMessage: OpenFOAM has stopped for one reason, and says it once
expectOneMessage()
{
    local n
    n=$(grep -c 'FOAM FATAL' log.pimpleFoam || true)
    [ "$n" -eq 1 ] || fail "$n fatal messages in place of one"
}

# waitForText FILE TEXT: until the file has it
waitForText()
{
    local deadline=$((SECONDS + 20))
    until grep -q -F -- "$2" "$1" 2> /dev/null
    do
        [ "$SECONDS" -lt "$deadline" ] || fail "no '$2' in $1"
        sleep 0.02
    done
}

# expectText FILE TEXT...: the file has each of the texts, however it is wrapped
expectText()
{
    local file=$1 text
    shift
    for text in "$@"
    do
        tr -s '[:space:]' ' ' < "$file" | grep -q -F -- "$text" \
            || fail "$file does not say '$text'"
    done
}

# expectNoText FILE TEXT
expectNoText()
{
    if grep -q -F -- "$2" "$1"
    then
        fail "$1 says '$2'"
    fi
}

# expectEqual WHAT ACTUAL EXPECTED
expectEqual()
{
    [ "$2" = "$3" ] || fail "$1: $2, expected $3"
}
