// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"

namespace tokay::channel {

/// Carries out a Handshake over a channel and trusts the peer. A peer that is
/// refused is told why.
/// @param token  the shared secret; empty over a socket pair
/// @return  the peer's Hello
/// @throws  PeerError that names both versions, both roles, or the wrong token
Hello shakeHands(Channel& channel, const Hello& own, const std::string& token = "");

} // namespace tokay::channel
