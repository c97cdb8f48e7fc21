#!/usr/bin/env bash
# Dictionaries that are edited while the run goes on: what can change changes, the rest
# stays as it was, and both are reported.
source "$(dirname "$0")/harness.sh"

# startLongRun [BEHAVIOUR]: a run without an end, some steps old
startLongRun()
{
    makeCase fluid
    behave "${1:-creeps}"
    entry system/controlDict runTimeModifiable yes
    entry system/controlDict endTime 1000
    entry system/controlDict writeInterval 1000
    "${2:-true}"
    startFluid
    waitForText log.pimpleFoam "Time = 0.03"
    edits=0
}

# edit FILE COMMAND...: changes a file of the running case, which notices changes that
# are more than ten seconds newer than the file it has read
edit()
{
    local file=$1 copy=edited/${1##*/}
    shift
    edits=$((edits + 1))
    mkdir -p edited
    cp "$file" "$copy"
    "$@" "$copy"
    touch -d "+$edits hour" "$copy"
    mv "$copy" "$file"
}

setEntry() { entry "$3" "$1" "$2"; }

dropEntry() { removeEntry "$2" "$1"; }

# stopRun: ends the run after the present step, in good order
stopRun()
{
    local status=0
    edit system/controlDict setEntry stopAt writeNow
    wait "$fluid" || status=$?
    [ "$status" -eq 0 ] || fail "the run has ended with status $status"
    expectNoProcess 5
}

# waitForSteps N: that many more
waitForSteps()
{
    local last
    last=$(grep -c '^Time = ' log.pimpleFoam)
    local deadline=$((SECONDS + 20))
    until [ "$(grep -c '^Time = ' log.pimpleFoam)" -ge $((last + $1)) ]
    do
        [ "$SECONDS" -lt "$deadline" ] || fail "no $1 more steps"
        sleep 0.05
    done
}

# expectAllRows: the tables have a row for each time step, and the structure has been
# told the end
expectAllRows()
{
    grep '^Time = ' log.pimpleFoam | awk '{ print $3 }' > times
    grep -v '^#' postProcessing/structure/0/coupling.dat | awk '{ print $1 }' > rows
    cmp -s times rows || fail "rows of the table: $(wc -l < rows), time steps: $(wc -l < times)"
    expectEqual "steps of the structure" "$(grep -c '^step ' record)" "$(wc -l < times)"
    expectText log.igaStructure "goodbye: the fluid's run has ended"
}

property disabled "a function object that is disabled leaves the coupling and its tables as they were, and is reported"
disabled()
{
    startLongRun
    edit system/controlDict setEntry functions.structure.enabled no
    waitForText log.pimpleFoam "the function object 'structure' was disabled or removed while the coupling runs"
    waitForSteps 3
    stopRun
    expectAllRows
}

property removed "so does one that is removed, and all of them"
removed()
{
    startLongRun
    edit system/controlDict dropEntry functions
    waitForText log.pimpleFoam "the function object 'structure' was disabled or removed while the coupling runs"
    waitForSteps 3
    stopRun
    expectAllRows
}

property enabledAgain "one that is enabled again takes the coupling over"
enabledAgain()
{
    startLongRun
    edit system/controlDict setEntry functions.structure.enabled no
    waitForText log.pimpleFoam "was disabled or removed"
    waitForSteps 2
    edit system/controlDict setEntry functions.structure.enabled yes
    waitForText log.pimpleFoam "the coupling runs already"
    waitForSteps 2
    stopRun
    expectAllRows
}

property entries "entries of the coupling that change are named, and take effect at the next start"
entries()
{
    startLongRun
    edit system/controlDict setEntry functions.structure.rho 2
    waitForText log.pimpleFoam "changes take effect at the next start: rho"
    stopRun
    expectAllRows
}

property loweredToOne "nOuterCorrectors lowered to 1 does not switch the abort off"
loweredToOne()
{
    startLongRun
    edit system/fvSolution setEntry PIMPLE.nOuterCorrectors 1
    expectBadEnd
    expectOneMessage
    expectText log.pimpleFoam "nOuterCorrectors is now 1 instead of 50; the coupling stays strong until the next start" \
        "did not converge in 1 outer correctors: above the tolerance of residualControl: structure 1 (tolerance 0.0001)"
}

property fewer "fewer outer correctors and another tolerance of U take effect at once"
fewer()
{
    startLongRun
    edit system/fvSolution setEntry PIMPLE.nOuterCorrectors 40
    waitForText log.pimpleFoam "nOuterCorrectors is now 40 instead of 50"
    edit system/fvSolution setEntry PIMPLE.residualControl.U.tolerance 1e-3
    waitForText log.pimpleFoam "the tolerance of U is now 0.001"
    waitForSteps 2
    stopRun
    expectAllRows
}

# leaveToPreset: tolerances
leaveToPreset()
{
    removeEntry system/fvSolution PIMPLE.residualControl
    coupling preset fast
}

property preset "tolerances that a preset has set stay when fvSolution is read anew"
preset()
{
    startLongRun creeps leaveToPreset
    edit system/fvSolution setEntry PIMPLE.nOuterCorrectors 40
    waitForText log.pimpleFoam "nOuterCorrectors is now 40 instead of 50"
    waitForSteps 3
    stopRun
    expectAllRows
    expectNoText log.pimpleFoam "has been removed; it stays in force"
    # Without them PIMPLE would run all its outer correctors
    awk '!/^#/ && $3 > 20 { exit 1 }' postProcessing/structure/0/coupling.dat || fail "a step did not end by its residuals"
}

property tolerance "the coupling keeps the tolerance of its start"
tolerance()
{
    startLongRun
    edit system/fvSolution setEntry PIMPLE.residualControl.structure.tolerance 0.9
    waitForText log.pimpleFoam "the tolerance of structure is now 0.9; the coupling keeps that of its start until the next start"
    waitForSteps 3
    stopRun
    expectAllRows
    # The structure needs four coupling iterations, and one more is final
    awk '$1 == "step" { if (n && n < 5) exit 1; n = 0 } $1 == "forces" { ++n }' record \
        || fail "a step has ended before the structure had converged"
}

makeExplicit()
{
    entry system/fvSolution PIMPLE.nOuterCorrectors 1
}

property raised "an explicit coupling stays explicit when nOuterCorrectors is raised"
raised()
{
    startLongRun sway makeExplicit
    edit system/fvSolution setEntry PIMPLE.nOuterCorrectors 4
    waitForText log.pimpleFoam "nOuterCorrectors is now 4 instead of 1; the coupling stays explicit until the next start"
    waitForSteps 3
    stopRun
    expectAllRows
    expectEqual "coupling iterations per step" \
        "$(awk '$1 == "step" { if (n) print n; n = 0 } $1 == "forces" { ++n }' record | sort -u)" 1
}

runProperties "$@"
