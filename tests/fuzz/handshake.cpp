// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/PeerError.hpp"
#include "channel/connectedPair.hpp"
#include "channel/handshake/shakeHands.hpp"
#include "fuzz/fuzz.hpp"

// The bytes of a stranger, against a structure that waits for the fluid.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tokay::channel;
    const auto [stranger, own] = socketPair();
    const ssize_t sent = write(stranger, data, std::min<std::size_t>(size, 1 << 15));
    shutdown(stranger, SHUT_WR);
    Channel channel = Channel::fromFileDescriptor(own);
    Hello hello;
    hello.role = Role::structure;
    const int result = tokay::fuzz::run([&] {
        try {
            shakeHands(channel, hello, "secret");
        } catch (const PeerError&) {
        }
    });
    close(stranger);
    return sent < 0 ? 0 : result;
}
