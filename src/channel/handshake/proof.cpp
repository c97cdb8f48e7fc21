// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/proof.hpp"

#include "common/errors.hpp"

#include <nettle/hmac.h>
#include <nettle/memops.h>
#include <sys/random.h>

namespace tokay::channel {

std::array<std::uint8_t, 32> hmacSha256(const std::string& key, const Bytes& message) {
    hmac_sha256_ctx context;
    hmac_sha256_set_key(&context, key.size(), reinterpret_cast<const std::uint8_t*>(key.data()));
    hmac_sha256_update(&context, message.size(), message.data());
    std::array<std::uint8_t, 32> digest;
    hmac_sha256_digest(&context, digest.size(), digest.data());
    return digest;
}

Nonce randomNonce() {
    Nonce nonce;
    if (getrandom(nonce.data(), nonce.size(), 0) != static_cast<ssize_t>(nonce.size())) {
        throw SolverError("the system has no random numbers for a handshake");
    }
    return nonce;
}

Proof proofOf(Role side, const std::string& token, const Hello& fluid, const Hello& structure) {
    const std::string label = side == Role::structure ? "Tokay structure" : "Tokay fluid";
    Bytes message(label.begin(), label.end());
    for (const Hello* hello : {&fluid, &structure}) {
        const Bytes frame = encodeFrame(*hello);
        message.insert(message.end(), frame.begin(), frame.end());
    }
    return {hmacSha256(token, message)};
}

bool isSame(const Proof& a, const Proof& b) {
    return memeql_sec(a.digest.data(), b.digest.data(), a.digest.size()) != 0;
}

} // namespace tokay::channel
