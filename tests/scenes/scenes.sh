# Usage: source ../scenes.sh
#
# What the scenes share: the harness of the adapter's tests, and the scene's case.

scene=$(cd "$(dirname "$0")" && pwd)
TOKAY_TEST_FOLDER=${TOKAY_TEST_FOLDER:-${TOKAY_BUILD:-$scene/../../../build/release}/tests/scenes/runs}
source "$scene/../../foamAdapter/harness.sh"
scriptName=$(basename "$scene")

# makeScene FOLDER [SCENE]: a copy of the scene's case (or another scene's) in a
# folder of the property; goes to its fluid, or to the folder if it has none
makeScene()
{
    cd "$propertyFolder"
    cp -r "$scene/../${2:-$scriptName}" "$1"
    cd "$1"
    [ ! -d fluid ] || cd fluid
}

# runScene: the fluid's mesh, and the run to a good end
runScene()
{
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    runFluid
}

# watchPoint TIME [COLUMN]: displacement [m] in the structure's table of watch
# points; column 1 is the first point's first component
watchPoint()
{
    awk -v time="$1" -v column="$((1 + ${2:-1}))" '
        !/^#/ && ($1 - time)^2 < 1e-16 { value = $column; found = 1 }
        END { if (!found) exit 1; print value }' ../structure/postProcessing/*/0/watchPoints.dat \
        || fail "no watch point at $1 s"
}

# expectClose WHAT ACTUAL EXPECTED TOLERANCE: the tolerance is a fraction of EXPECTED
expectClose()
{
    awk -v a="$2" -v e="$3" -v t="$4" \
        'BEGIN { d = a - e; s = e < 0 ? -e : e; exit !(d <= t*s && -d <= t*s) }' \
        || fail "$1: $2, expected $3 within a fraction of $4"
}
