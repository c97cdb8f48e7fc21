#!/usr/bin/env bash
# bin/couplingSummary on tables made by hand
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
run=$(mktemp -d)
trap 'rm -rf "$run"' EXIT

fail()
{
    printf 'FAILED: %s\n' "$1"
    exit 1
}

table=$run/fluid/postProcessing/structure/0
mkdir -p "$table"

# summary RESIDUAL CONVERGED: of two steps, the second with these
summary()
{
    printf '# Coupling of structure, tolerance 0.0001\n# time\n0.1 0.1 3 3 5e-5 1e-5 1 2 0.1 0.1\n0.2 0.1 5 4 %s 1e-5 %s 2 0.1 0.3\n' "$1" "$2" > "$table/coupling.dat"
    status=0
    output=$("$repository/bin/couplingSummary" "$run" 2>&1) || status=$?
}

summary 9e-5 1
[ "$status" -eq 0 ] || fail "two converged steps, but status $status: $output"
grep -q '2 steps, 2 converged, largest coupling residual 9.00e-05 (tolerance 1e-04)' <<< "$output" || fail "steps: $output"
grep -q 'outer correctors per time step: mean 4.00, at most 5' <<< "$output" || fail "correctors: $output"
grep -q 'outside the fluid solver 15.00 %' <<< "$output" || fail "seconds: $output"

summary 2e-4 1
[ "$status" -ne 0 ] || fail "a step above its tolerance is reported by status 0"
grep -q 'ABOVE ITS TOLERANCE' <<< "$output" || fail "above the tolerance: $output"

summary 9e-5 0
[ "$status" -ne 0 ] || fail "a step that did not converge is reported by status 0"
grep -q 'NOT EVERY STEP CONVERGED' <<< "$output" || fail "not converged: $output"

# A restart has a table of its own, with its own tolerance; 0 comes before 0.2
mkdir "$run/fluid/postProcessing/structure/0.2"
# restart RESIDUAL: by a step with this one
restart()
{
    printf '# Coupling of structure, tolerance 1e-05\n# time\n0.3 0.1 4 4 %s 1e-5 1 2 0.1 0.1\n' "$1" \
        > "$run/fluid/postProcessing/structure/0.2/coupling.dat"
    summary 9e-5 1
}

restart 8e-6
[ "$status" -eq 0 ] || fail "a tighter tolerance after a restart, but status $status: $output"
grep -q '^3 steps, 3 converged, largest coupling residual 9.00e-05 (tolerance 1e-04), 8.00e-06 (tolerance 1e-05)$' \
    <<< "$output" || fail "after a restart: $output"

restart 2e-5
[ "$status" -ne 0 ] || fail "a step above the restart's tolerance is reported by status 0"
