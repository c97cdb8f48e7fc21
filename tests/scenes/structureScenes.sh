# Usage: source ../structureScenes.sh
#
# What scenes of a structure alone share.
source "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"

# runStructure CASE: igaStructure runs it to a good end
runStructure()
{
    igaStructure run "$1" > log.igaStructure 2>&1 || { tail -n 5 log.igaStructure; fail "$1 failed"; }
}

# expectRefused check|run CASE TEXT: one message with the text, and a status that is not zero
expectRefused()
{
    local status=0
    igaStructure "$1" "$2" > log.igaStructure 2>&1 || status=$?
    [ "$status" -eq 1 ] || fail "igaStructure $1 $2 ended with status $status"
    expectText log.igaStructure "$3"
}

# watch NAME COLUMN: last displacement in the table of watch points [m]
watch()
{
    awk -v column="$((1 + $2))" '!/^#/ { value = $column } END { print value }' \
        "postProcessing/$1/0/watchPoints.dat"
}
