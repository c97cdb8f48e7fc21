// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/shakeHands.hpp"

#include "channel/handshake/Handshake.hpp"

namespace tokay::channel {
namespace {

void converse(Channel& channel, Handshake& handshake) {
    std::optional<Message> next = handshake.begin();
    while (!handshake.isComplete()) {
        if (next) {
            channel.send(*next);
        }
        next = handshake.answer(channel.receive(handshake.awaited()));
    }
    if (next) {
        channel.send(*next);
    }
}

} // namespace

Hello shakeHands(Channel& channel, const Hello& own, const std::string& token) {
    Handshake handshake(own, token);
    try {
        converse(channel, handshake);
    } catch (const PeerFailure&) {
        throw;
    } catch (const PeerError& error) {
        channel.trySend(Failure{error.what()});
        throw;
    }
    channel.trust(handshake.peerName());
    return handshake.peer();
}

} // namespace tokay::channel
