#!/usr/bin/env bash
# Mistakes in the structure's case file are told by both sides, at the start.
source "$(dirname "$0")/harness.sh"

# expectRefusal TEXT...: both logs say this, and no time step begins
expectRefusal()
{
    runFaultyFluid "${ranks:-1}"
    expectText log.pimpleFoam "the structure ended: " "$@"
    expectText log.igaStructure "igaStructure: error: " "$@"
    expectNoText log.pimpleFoam "Time = "
    [ ! -e structure/results ] || fail "there are results"
}

property caseMissing "a missing case file is named"
caseMissing()
{
    makeFlap fluid
    rm structure/case.yaml
    expectRefusal "fluid/structure/case.yaml"
}

property malformed "a malformed case file is named, with the line"
malformed()
{
    makeFlap fluid
    flapEntry "poissonsRatio: 0.3" "poissonsRatio: [0.3"
    # The parser notices at the next entry
    expectRefusal "case.yaml:$(grep -n 'density' structure/case.yaml | cut -d : -f 1)" "this is not YAML"
}

property unknownKey "an unknown key in the case file is named, with its line and what was meant"
unknownKey()
{
    makeFlap fluid
    flapEntry youngsModulus youngModulus
    expectRefusal "case.yaml:$(grep -n 'youngModulus' structure/case.yaml | cut -d : -f 1)" \
        youngModulus "did you mean" youngsModulus
}

property range "a value out of range in the case file is named, with its line and the range"
range()
{
    makeFlap fluid
    flapEntry "poissonsRatio: 0.3" "poissonsRatio: 0.5"
    expectRefusal "case.yaml:$(grep -n 'poissonsRatio' structure/case.yaml | cut -d : -f 1)" "(-1, 0.5)"
}

property alone "a case file without a coupling is refused"
alone()
{
    makeFlap fluid
    sed -i '/^coupling:/,/^$/d' structure/case.yaml
    expectRefusal "entry 'coupling' is missing"
}

property gap "an interface that does not lie on the structure is refused, with the largest gap"
gap()
{
    makeFlap fluid
    # The whole flap 0.2 m to the right
    flapEntry "origin: [-0.05, 0]" "origin: [0.15, 0]"
    expectRefusal "do not lie on each other: point" "is 0.2 m away" "the limit is 0.01"
}

property parallel "in parallel a mistake in the case file is reported once"
parallel()
{
    makeFlap fluid
    flapEntry youngsModulus youngModulus
    decompose 2
    ranks=2
    expectRefusal youngModulus "did you mean"
    expectOneMessage
}

runProperties "$@"
