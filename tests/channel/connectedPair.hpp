// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"

#include <sys/socket.h>

#include <stdexcept>
#include <utility>

namespace tokay::channel {

/// The two ends of a new socket pair.
inline std::pair<int, int> socketPair() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        throw std::runtime_error("no socket pair");
    }
    return {ends[0], ends[1]};
}

inline std::pair<Channel, Channel> connectedPair() {
    const auto [first, second] = socketPair();
    return {Channel::fromFileDescriptor(first), Channel::fromFileDescriptor(second)};
}

/// What() of the error of type Error that `action` throws; "" if none.
template <class Error, class Action>
std::string errorOf(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace tokay::channel
