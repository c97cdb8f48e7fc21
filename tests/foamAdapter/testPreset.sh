#!/usr/bin/env bash
# A preset sets what its table says and no more, an entry that is given wins, and the
# log names what has been set.
source "$(dirname "$0")/harness.sh"

# The table of presets as the manual has it: what stands in the case instead
declare -A tolerances=([fast]=1e-3 [balanced]=1e-4 [reference]=1e-6)
declare -A pressures=([fast]=relaxed [balanced]=relaxed [reference]=relaxed)
declare -A predictors=([fast]=quadratic [balanced]=quadratic [reference]=quadratic)

# makeBare FOLDER: a flap without entries that presets set
makeBare()
{
    cd "$propertyFolder"
    makeFlap "$1"
    entry system/controlDict endTime 0.05
    flapEntry "  predictor: quadratic" ""
    removeEntry system/fvSolution PIMPLE.residualControl
}

# usePreset NAME: on both sides
usePreset()
{
    coupling preset "$1"
    flapEntry "coupling:" "coupling:
  preset: $1"
}

# giveEntries NAME: those of the preset
giveEntries()
{
    entry system/fvSolution PIMPLE.residualControl \
        "{ structure { tolerance ${tolerances[$1]}; relTol 0; } U { tolerance ${tolerances[$1]}; relTol 0; } }"
    coupling pressureTolerance "${pressures[$1]}"
    flapEntry "coupling:" "coupling:
  predictor: ${predictors[$1]}"
}

# steps FOLDER: of each its time, correctors, iterations and residuals
steps()
{
    grep -v '^#' "$propertyFolder/$1/postProcessing/structure/0/coupling.dat" | cut -f 1-7
}

# expectSameRun FOLDER FOLDER: to the last digit
expectSameRun()
{
    [ -n "$(steps "$1")" ] || fail "no steps"
    expectEqual "steps of $1" "$(steps "$1")" "$(steps "$2")"
}

# expectTable NAME
expectTable()
{
    makeBare preset
    usePreset "$1"
    runFluid
    expectText log.pimpleFoam "preset $1 sets residualControl.structure.tolerance ${tolerances[$1]}, \
residualControl.U.tolerance ${tolerances[$1]}, pressureTolerance ${pressures[$1]}" \
        "preset $1 sets predictor ${predictors[$1]}"
    makeBare given
    giveEntries "$1"
    runFluid
    expectNoText log.pimpleFoam "preset"
    expectSameRun preset given
}

property fast "preset fast is what its table says, digit by digit"
fast() { expectTable fast; }

property balanced "so is balanced"
balanced() { expectTable balanced; }

property reference "so is reference"
reference() { expectTable reference; }

property defaults "a case without a preset is that of balanced, with tolerances of 1e-4 and the predictor quadratic"
defaults()
{
    makeBare preset
    usePreset balanced
    runFluid
    makeBare none
    entry system/fvSolution PIMPLE.residualControl \
        '{ structure { tolerance 1e-4; relTol 0; } U { tolerance 1e-4; relTol 0; } }'
    flapEntry "coupling:" "coupling:
  predictor: quadratic"
    runFluid
    expectSameRun preset none
}

property explicitWins "an entry that is given wins, and the log names the others only"
explicitWins()
{
    makeBare fluid
    usePreset reference
    entry system/fvSolution PIMPLE.residualControl '{ structure { tolerance 1e-3; relTol 0; } }'
    coupling pressureTolerance fixed
    flapEntry "coupling:" "coupling:
  predictor: constant"
    runFluid
    expectText log.pimpleFoam "strong coupling, tolerance 0.001" \
        "preset reference sets residualControl.U.tolerance 1e-6" \
        "preset reference sets nothing: all of its entries are given" "predictor constant"
    expectNoText log.pimpleFoam "sets residualControl.structure" "pressureTolerance relaxed"
}

property pattern "a pattern of residualControl that matches a field gives it"
pattern()
{
    makeBare fluid
    usePreset fast
    entry system/fvSolution PIMPLE.residualControl '{ "(U|structure)" { tolerance 1e-4; relTol 0; } }'
    runFluid
    expectText log.pimpleFoam "strong coupling, tolerance 0.0001" "preset fast sets pressureTolerance relaxed"
}

property explicitCoupling "an explicit coupling has no tolerances for a preset to set"
explicitCoupling()
{
    makeBare fluid
    usePreset fast
    entry system/fvSolution PIMPLE.nOuterCorrectors 1
    runFluid
    expectText log.pimpleFoam "preset fast sets pressureTolerance relaxed"
    expectNoText log.pimpleFoam "sets residualControl"
}

property unknownFluid "an unknown preset of the function object is refused, with its place and those there are"
unknownFluid()
{
    makeBare fluid
    usePreset fast
    coupling preset quick
    runFaultyFluid
    expectText log.pimpleFoam "preset: quick; allowed: fast, balanced, reference" "controlDict.functions.structure"
    [ ! -s log.igaStructure ] || fail "the structure was started in vain"
}

property unknownStructure "an unknown preset of the case file is refused, with its line and those there are"
unknownStructure()
{
    makeBare fluid
    giveEntries fast
    flapEntry "coupling:" "coupling:
  preset: quick"
    runFaultyFluid
    expectText log.pimpleFoam "case.yaml:$(grep -n 'preset' structure/case.yaml | cut -d : -f 1)" \
        "coupling.preset: 'quick' is not allowed; allowed: fast, balanced, reference"
}

runProperties "$@"
