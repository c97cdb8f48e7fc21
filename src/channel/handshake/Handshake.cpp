// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/Handshake.hpp"

#include "channel/PeerError.hpp"
#include "channel/encoding.hpp"
#include "channel/handshake/proof.hpp"

namespace tokay::channel {
namespace {

std::string nameOf(Role role) {
    return role == Role::fluid       ? "the fluid"
           : role == Role::structure ? "the structure"
                                     : "the moved structure";
}

template <class Expected>
const Expected& require(const Message& message, const std::string& awaited) {
    if (const auto* expected = std::get_if<Expected>(&message)) {
        return *expected;
    }
    throw PeerError(std::string("a message of type ") + typeName(message.index()) +
                    " arrived while this side waited for " + awaited);
}

} // namespace

Handshake::Handshake(Hello own, std::string token)
    : own_(std::move(own)), token_(std::move(token)) {
    own_.nonce = randomNonce();
}

std::optional<Message> Handshake::begin() const {
    return own_.role != Role::structure ? std::optional<Message>(own_) : std::nullopt;
}

std::optional<Message> Handshake::answer(const Message& message) {
    if (const auto* failure = std::get_if<Failure>(&message)) {
        throw PeerFailure(peerName() + " ended: " + failure->text);
    }
    return peer_ ? answerProof(message) : answerGreeting(message);
}

std::optional<Message> Handshake::answerGreeting(const Message& message) {
    const auto& greeting = require<Hello>(message, awaited());
    requireAcceptable(greeting);
    peer_ = greeting;
    return own_.role != Role::structure ? Message(proof(own_.role)) : Message(own_);
}

std::optional<Message> Handshake::answerProof(const Message& message) {
    if (!isSame(require<Proof>(message, awaited()), proof(peer_->role))) {
        throw PeerError(nameOf(peer_->role) +
                        " gave a wrong token: give both sides the same secret");
    }
    isComplete_ = true;
    return own_.role != Role::structure ? std::nullopt : std::optional<Message>(proof(own_.role));
}

void Handshake::requireAcceptable(const Hello& peer) const {
    if (peer.protocol != own_.protocol) {
        throw PeerError("protocol version " + std::to_string(peer.protocol) + " of " +
                        peer.program + " arrived, " + own_.program + " speaks version " +
                        std::to_string(own_.protocol) + ": install the same Tokay on both sides");
    }
    if ((peer.role == Role::structure) == (own_.role == Role::structure)) {
        throw PeerError(peer.role == own_.role
                            ? "both sides are " + nameOf(own_.role) +
                                  ": connect a fluid to a structure"
                            : nameOf(own_.role) + " met " + nameOf(peer.role) +
                                  ": connect each to a structure that is loaded");
    }
}

Proof Handshake::proof(Role side) const {
    return own_.role != Role::structure ? proofOf(side, token_, own_, *peer_)
                                        : proofOf(side, token_, *peer_, own_);
}

std::string Handshake::peerName() const {
    return peer_ ? nameOf(peer_->role) : "the peer";
}

std::string Handshake::awaited() const {
    return peer_ ? "the proof that " + peerName() + " knows the token" : "the peer's greeting";
}

} // namespace tokay::channel
