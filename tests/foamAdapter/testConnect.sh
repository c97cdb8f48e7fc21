#!/usr/bin/env bash
# A structure that was started elsewhere: the fluid connects to it.
source "$(dirname "$0")/harness.sh"

# startStructure ADDRESS [ARGUMENT...]: igaStructure waits for a fluid; sets
# address to where, and lets the case connect to it
startStructure()
{
    makeFlap fluid
    printf 'open sesame\n' > token
    set -m
    env "$mark" igaStructure run structure/case.yaml --listen "$@" > log.igaStructure 2>&1 &
    set +m
    structure=$!
    waitForText log.igaStructure "waiting for a fluid at"
    address=$(sed -n 's/^waiting for a fluid at //p' log.igaStructure)
    removeEntry system/controlDict functions.structure.structure
    entry system/controlDict functions.structure.structure "{ connect \"$address\"; $connectEntries }"
}
connectEntries=

# expectStructureStatus zero|notZero
expectStructureStatus()
{
    local status=0
    wait "$structure" || status=$?
    if [ "$1" = zero ]
    then
        [ "$status" -eq 0 ] || fail "the structure has ended with status $status"
    else
        [ "$status" -ne 0 ] || fail "the structure has ended with status 0"
    fi
}

property tcp "a fluid connects by tcp with the token of the structure"
tcp()
{
    connectEntries='tokenFile "token";'
    startStructure "tcp://:0" --token-file token
    runFluid
    expectText log.pimpleFoam "connected to tcp://127.0.0.1:"
    expectText log.igaStructure "step 3 time 0.03 s"
    expectStructureStatus zero
}

property unixSocket "a fluid connects by a unix socket without a token"
unixSocket()
{
    startStructure "unix:socket"
    runFluid
    expectText log.igaStructure "step 3 time 0.03 s"
    expectStructureStatus zero
}

property wrongToken "a wrong token is refused by the structure, and both sides end"
wrongToken()
{
    connectEntries='tokenFile "wrongToken";'
    startStructure "tcp://:0" --token-file token
    printf 'open barley\n' > wrongToken
    runFaultyFluid
    expectText log.pimpleFoam "the fluid gave a wrong token: give both sides the same secret"
    expectText log.igaStructure "the fluid gave a wrong token: give both sides the same secret"
    expectStructureStatus notZero
}

property noToken "no token is refused by the structure, and both sides end"
noToken()
{
    startStructure "tcp://:0" --token-file token
    runFaultyFluid
    expectText log.pimpleFoam "the fluid gave a wrong token"
    expectText log.igaStructure "the fluid gave a wrong token"
    expectStructureStatus notZero
}

property tokenFile "a token file that is not there is named"
tokenFile()
{
    connectEntries='tokenFile "noToken";'
    startStructure "tcp://:0" --token-file token
    startTime=$SECONDS
    runFaultyFluid
    expectText log.pimpleFoam "the token file '" "fluid/noToken' cannot be read or has an empty first line"
    expectStructureStatus notZero
}

property nobody "an address where nobody listens is named"
nobody()
{
    makeCase fluid
    removeEntry system/controlDict functions.structure.structure
    entry system/controlDict functions.structure.structure '{ connect "unix:nobody"; }'
    runFaultyFluid
    expectText log.pimpleFoam 'nobody answers at "unix:nobody"' "start the structure first, with the same address"
}

property address "an address of another form is refused, and the forms are listed"
address()
{
    makeCase fluid
    removeEntry system/controlDict functions.structure.structure
    entry system/controlDict functions.structure.structure '{ connect "localhost:5000"; }'
    runFaultyFluid
    expectText log.pimpleFoam "localhost:5000" "unix:/path" "tcp://host:port"
}

property stranger "a stranger who sends garbage to a waiting structure ends it, with a message"
stranger()
{
    startStructure "tcp://:0" --token-file token
    # It may close before all has arrived
    (trap '' PIPE; printf 'GET / HTTP/1.1\r\n\r\n' > "/dev/tcp/127.0.0.1/${address##*:}") || true
    expectStructureStatus notZero
    expectText log.igaStructure "what arrived is not a message of Tokay"
    expectNoProcess 5
}

runProperties "$@"
