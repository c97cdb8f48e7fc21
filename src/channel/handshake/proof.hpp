// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/encoding.hpp"

#include <string>

namespace tokay::channel {

/// A keyed digest, HMAC-SHA256.
/// Source: RFC 2104, FIPS 180-4
std::array<std::uint8_t, 32> hmacSha256(const std::string& key, const Bytes& message);

/// From the system's generator. @throws SolverError if that has none
Nonce randomNonce();

/// Shows that a side knows the token: the keyed digest of its role and of both
/// greetings, nonces included. Who listens learns nothing that helps in another
/// handshake, nor can one side's proof be returned as the other's.
Proof proofOf(Role side, const std::string& token, const Hello& fluid, const Hello& structure);

/// Takes as long wherever the two differ.
bool isSame(const Proof& a, const Proof& b);

} // namespace tokay::channel
