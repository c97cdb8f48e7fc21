#!/usr/bin/env bash
# bin/installDependencies on machines that are not this one: stubs of dpkg-query,
# id, sudo and apt-get stand first on the PATH.
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
stubs=$(mktemp -d)
trap 'rm -rf "$stubs"' EXIT

stub()
{
    printf '#!/bin/sh\n%s\n' "$2" > "$stubs/$1"
    chmod +x "$stubs/$1"
}

fail()
{
    printf 'FAILED: %s\n' "$1"
    exit 1
}

run()
{
    status=0
    output=$(PATH=$stubs:$PATH "$repository/bin/installDependencies" 2>&1) || status=$?
}

unset WM_PROJECT_DIR
stub apt-get "echo \"\$@\" >> $stubs/called"

# All is there: nothing is called
stub dpkg-query 'printf installed'
run
[ "$status" -eq 0 ] || fail "all packages there, but status $status"
[ ! -e "$stubs/called" ] || fail "all packages there, but apt-get was called"

# Packages missing, neither root nor sudo: the one command, and nothing done
stub dpkg-query 'exit 1'
stub id 'echo 1000'
stub sudo 'exit 1'
run
[ "$status" -ne 0 ] || fail "missing packages reported by status 0"
grep -q 'sudo sh -c "apt-get update && apt-get install .*libeigen3-dev.* openfoam.*"' <<< "$output" \
    || fail "the command to run is not in: $output"
[ ! -e "$stubs/called" ] || fail "apt-get was called without the right to"

# A sourced OpenFOAM is not installed a second time
mkdir -p "$stubs/OpenFOAM/wmake"
export WM_PROJECT_DIR=$stubs/OpenFOAM
run
grep -q ' openfoam' <<< "$output" && fail "openfoam asked for although one is sourced"
unset WM_PROJECT_DIR

# Root: installs
stub id 'echo 0'
run
[ "$status" -eq 0 ] || fail "as root: status $status, $output"
grep -q '^update' "$stubs/called" || fail "as root: no update"
grep -q '^install .*libeigen3-dev' "$stubs/called" || fail "as root: no install"

# The package manager fails: so does the script, with the log
stub apt-get 'echo "no network"; exit 100'
run
[ "$status" -ne 0 ] || fail "a failed installation reported by status 0"
grep -q 'no network' <<< "$output" || fail "the package manager's words are not in: $output"

echo passed
