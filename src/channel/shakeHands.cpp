// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/shakeHands.hpp"

namespace tokay::channel {
namespace {

std::string nameOf(Role role) {
    return role == Role::fluid ? "the fluid" : "the structure";
}

/// Compares without telling, by its duration, how much of the token is right.
bool equalTokens(const std::string& given, const std::string& own) {
    unsigned difference = given.size() == own.size() ? 0 : 1;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const char expected = own.empty() ? 0 : own[i % own.size()];
        difference |= static_cast<unsigned char>(given[i] ^ expected);
    }
    return difference == 0;
}

void requireAcceptable(const Hello& peer, const Hello& own) {
    if (peer.protocol != own.protocol) {
        throw PeerError("protocol version " + std::to_string(peer.protocol) + " of " +
                        peer.program + " arrived, " + own.program + " speaks version " +
                        std::to_string(own.protocol) + ": install the same Tokay on both sides");
    }
    if (peer.role == own.role) {
        throw PeerError("both sides are " + nameOf(own.role) + ": connect a fluid to a structure");
    }
    if (!equalTokens(peer.token, own.token)) {
        throw PeerError(nameOf(peer.role) + " gave a wrong token: give both sides the same secret");
    }
}

Hello receiveAcceptable(Channel& channel, const Hello& own) {
    try {
        const Hello peer = channel.receive<Hello>("the peer's greeting");
        requireAcceptable(peer, own);
        return peer;
    } catch (const PeerFailure&) {
        throw;
    } catch (const PeerError& error) {
        channel.trySend(Failure{error.what()});
        throw;
    }
}

} // namespace

Hello shakeHands(Channel& channel, const Hello& own) {
    if (own.role == Role::fluid) {
        channel.send(own);
    }
    const Hello peer = receiveAcceptable(channel, own);
    if (own.role == Role::structure) {
        channel.send(own);
    }
    channel.trust(nameOf(peer.role));
    return peer;
}

} // namespace tokay::channel
