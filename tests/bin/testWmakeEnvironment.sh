#!/usr/bin/env bash
# bin/wmakeEnvironment and bin/openfoamHeaders with an OpenFOAM that cannot be built
# against, and with objects that another one has compiled.
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail()
{
    printf 'FAILED: %s\n%s\n' "$1" "${output:-}"
    exit 1
}

# makeOpenfoam FOLDER API: what an OpenFOAM of openfoam.com has, as far as is looked at
makeOpenfoam()
{
    mkdir -p "$work/$1/wmake" "$work/$1/META-INFO" "$work/$1/src/OpenFOAM/primitives/enums"
    touch "$work/$1/src/OpenFOAM/primitives/enums/Enum.H"
    printf 'api=%s\npatch=0\n' "$2" > "$work/$1/META-INFO/api-info"
}

# prepare FOLDER [VARIABLE=VALUE...]: as Allwmake does it, for a library in $work/library
prepare()
{
    local folder=$work/$1
    shift
    status=0
    output=$(env -u FOAM_USER_LIBBIN WM_PROJECT_DIR="$folder" WM_PROJECT_VERSION=v0 WM_OPTIONS=linuxTest "$@" \
        bash -euo pipefail -c 'source "$1/bin/environment"; source "$1/bin/wmakeEnvironment" "$2"' \
        _ "$repository" "$work/library/Make/options" 2>&1) || status=$?
}

# expectRefusal TEXT: it has stopped with this one line
expectRefusal()
{
    [ "$status" -ne 0 ] || fail "status 0 in place of the message '$1'"
    [ "$(wc -l <<< "$output")" -eq 1 ] || fail "more than one line"
    [[ $output == *"$1"* ]] || fail "no '$1' in:"
}

mkdir -p "$work/library/Make" "$work/withoutWmake" "$work/org/wmake"
makeOpenfoam old 1906
makeOpenfoam good 2306
makeOpenfoam other 2606

prepare withoutWmake
expectRefusal "which has no folder wmake"
prepare org
expectRefusal "is not openfoam.com's"
prepare old FOAM_USER_LIBBIN="$work/lib"
expectRefusal "is too old: source v1912 or later"
prepare good
expectRefusal "FOAM_USER_LIBBIN is not set"

# Objects stay with the OpenFOAM that has compiled them, and only with it
objects=$work/library/Make/linuxTest
prepare good FOAM_USER_LIBBIN="$work/lib"
[ "$status" -eq 0 ] || fail "an OpenFOAM as it should be is refused"
touch "$objects/some.o"
prepare good FOAM_USER_LIBBIN="$work/lib"
[ -e "$objects/some.o" ] || fail "objects of the same OpenFOAM are removed"
prepare other FOAM_USER_LIBBIN="$work/lib"
[ ! -e "$objects/some.o" ] || fail "objects of another OpenFOAM stay"
touch "$objects/some.o"
printf 'api=2606\npatch=260901\n' > "$work/other/META-INFO/api-info"
prepare other FOAM_USER_LIBBIN="$work/lib"
[ ! -e "$objects/some.o" ] || fail "objects of another patch level stay"

# Links and dependencies stay as long as no file comes or goes, and objects with them
known() { prepare other FOAM_USER_LIBBIN="$work/lib"; touch "$objects/some.o" "$objects/some.C.dep"; mkdir -p "$work/library/lnInclude"; }
known
prepare other FOAM_USER_LIBBIN="$work/lib"
[ -e "$objects/some.C.dep" ] && [ -d "$work/library/lnInclude" ] || fail "dependencies of the same files are removed"
for change in "touch new.H" "mv new.H renamed.H" "rm renamed.H"
do
    known
    (cd "$work/library" && $change)
    prepare other FOAM_USER_LIBBIN="$work/lib"
    [ ! -e "$objects/some.C.dep" ] && [ ! -e "$work/library/lnInclude" ] || fail "links stay after: $change"
    [ -e "$objects/some.o" ] || fail "objects are removed after: $change"
done

# openfoam.com's own package of the name 'openfoam'
mkdir "$work/stubs"
printf '#!/bin/sh\n[ "$1" = --listfiles ] && echo /usr/share/doc/openfoam || printf 2312.0\n' > "$work/stubs/dpkg-query"
chmod +x "$work/stubs/dpkg-query"
status=0
output=$(PATH=$work/stubs:$PATH "$repository/bin/openfoamHeaders" \
    "$repository/src/foamAdapter/Make/options" 2>&1) || status=$?
expectRefusal "the package 'openfoam' 2312.0 is openfoam.com's, not the distribution's"
