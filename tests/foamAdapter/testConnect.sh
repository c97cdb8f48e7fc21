#!/usr/bin/env bash
# A structure that was started elsewhere: the fluid connects to it.
source "$(dirname "$0")/harness.sh"

# startStructure ADDRESS [ARGUMENT...]: igaStructure waits for a fluid; sets
# address to where, and lets the case connect to it
startStructure()
{
    makeFlap fluid
    secret token 'open sesame'
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

# secret FILE TEXT: a token file as both sides ask for it
secret()
{
    printf '%s\n' "$2" > "$1"
    chmod 600 "$1"
}

# The fluid of the structure's token, as the last one, is served
expectService()
{
    removeEntry system/controlDict functions.structure.structure
    entry system/controlDict functions.structure.structure "{ connect \"$address\"; tokenFile \"token\"; }"
    runFluid
    expectText log.igaStructure "step 3 time 0.03 s"
    expectStructureStatus zero
}

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

# runRefusedFluid: as runFaultyFluid, but the structure stays
runRefusedFluid()
{
    local status=0
    fluidCommand
    env "$mark" timeout 20 "${command[@]}" > log.pimpleFoam 2>&1 || status=$?
    [ "$status" -ne 0 ] && [ "$status" -ne 124 ] || fail "the run has ended with status $status"
    kill -0 "$structure" || fail "the structure has ended"
    expectOneMessage
}

property wrongToken "a fluid with a wrong token is refused and told so, and the structure waits on"
wrongToken()
{
    connectEntries='tokenFile "wrongToken";'
    startStructure "tcp://:0" --token-file token
    secret wrongToken 'open barley'
    runRefusedFluid
    expectText log.pimpleFoam "the fluid gave a wrong token: give both sides the same secret"
    expectText log.igaStructure "refused 127.0.0.1:" "the fluid gave a wrong token: give both sides the same secret"
    expectService
}

property noToken "a fluid without a token is refused and told so, and the structure waits on"
noToken()
{
    startStructure "tcp://:0" --token-file token
    runRefusedFluid
    expectText log.pimpleFoam "the fluid gave a wrong token"
    expectText log.igaStructure "the fluid gave a wrong token"
    expectService
}

property tokenFile "a token file that is not there, or open to others, is named by the fluid"
tokenFile()
{
    connectEntries='tokenFile "noToken";'
    startStructure "tcp://:0" --token-file token
    runRefusedFluid
    expectText log.pimpleFoam "the token file '" "fluid/noToken' cannot be read or has an empty first line"
    secret noToken 'open sesame'
    chmod 640 noToken
    runRefusedFluid
    expectText log.pimpleFoam "fluid/noToken' is open to other users (mode 640): make it yours alone by 'chmod 600"
    expectService
}

property openTokenFile "a token file that is open to others is named by the structure"
openTokenFile()
{
    makeFlap fluid
    secret token 'open sesame'
    chmod 604 token
    if igaStructure run structure/case.yaml --listen "tcp://:0" --token-file token > log.igaStructure 2>&1
    then
        fail "the structure has started"
    fi
    expectText log.igaStructure "the token file 'token' is open to other users (mode 604)"
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

# Opens a connection as file descriptor FD, and sends TEXT
stranger()
{
    eval "exec $1<> /dev/tcp/127.0.0.1/${address##*:}"
    # The structure may close before all has arrived
    (trap '' PIPE; printf '%b' "$2" >&"$1") || true
}

property strangers "a waiting structure survives strangers, a hundred of them, and serves the fluid"
strangers()
{
    local fd
    startStructure "tcp://:0" --token-file token
    stranger 20 ''
    exec 20>&-
    stranger 21 'GET / HTTP/1.1\r\n\r\n'
    waitForText log.igaStructure "what arrived is not a message of Tokay"
    for fd in {22..121}
    do
        stranger "$fd" ''
    done
    expectService
    expectText log.igaStructure "it ended the connection before the handshake was complete"
}

runProperties "$@"
