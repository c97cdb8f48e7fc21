// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <optional>
#include <string>

namespace tokay::channel {

/// The handshake as one side sees it, whatever carries the messages: the fluid
/// greets, the structure greets, the fluid proves that it knows the token, then
/// the structure does. A stranger at a structure sees a random number, and
/// nothing that the token has touched.
class Handshake {
  public:
    /// @param token  the shared secret; empty over a socket pair
    Handshake(Hello own, std::string token);

    /// What this side sends first; the structure waits.
    std::optional<Message> begin() const;

    /// Takes the peer's next message.
    /// @return  what to send for it, if anything
    /// @throws  PeerError that names both versions, both roles, or the wrong token;
    ///          PeerFailure if the peer gives up
    std::optional<Message> answer(const Message& message);

    /// The peer has proved that it knows the token.
    bool isComplete() const { return isComplete_; }

    /// The peer's greeting, once it has come.
    const Hello& peer() const { return *peer_; }

    /// "the fluid", "the structure"
    std::string peerName() const;

    /// What is awaited, for messages.
    std::string awaited() const;

  private:
    Proof proof(Role side) const;
    void requireAcceptable(const Hello& peer) const;
    std::optional<Message> answerGreeting(const Message& message);
    std::optional<Message> answerProof(const Message& message);

    Hello own_;
    std::string token_;
    std::optional<Hello> peer_;
    bool isComplete_ = false;
};

} // namespace tokay::channel
