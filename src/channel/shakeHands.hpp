// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"

namespace tokay::channel {

/// Exchanges Hello messages and checks protocol version, role and token. The
/// fluid speaks first, so that a stranger who attaches to a listening
/// structure never sees its token. A peer that is refused is told why.
/// @return  the peer's Hello
/// @throws  PeerError that names both versions, both roles, or the wrong token
Hello shakeHands(Channel& channel, const Hello& own);

} // namespace tokay::channel
