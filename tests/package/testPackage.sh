#!/usr/bin/env bash
# Usage: testPackage.sh BUILD GENERATOR
#
# Installs geometry and mapper from a build tree to a temporary prefix; a project
# elsewhere finds the package, builds and runs. A component that is not there is
# not found.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1
generator=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

configure()
{
    cmake -S "$here/consumer" -B "$folder/$1" -G "$generator" -DCMAKE_BUILD_TYPE=Debug \
        -DCMAKE_PREFIX_PATH="$folder/prefix" "${@:2}" > "$folder/log.$1" 2>&1
}

fail()
{
    printf 'testPackage: %s\n' "$1" >&2
    cat "$folder"/log.* >&2
    exit 1
}

cmake --install "$build" --component library --prefix "$folder/prefix" > "$folder/log.install"
configure build || fail "the package is not found"
cmake --build "$folder/build" > "$folder/log.build" 2>&1 || fail "the consumer does not build"
"$folder/build/consumer"

if grep -rE "Werror|$build" "$folder"/prefix/lib*/cmake
then
    fail "the package names options or folders of its own build"
fi
configure wings -DCONSUMER_COMPONENT=wings && fail "a component that does not exist is found"
grep -q wings "$folder/log.wings" || fail "the missing component is not named"
