// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace tokay::channel {

struct UnixAddress {
    std::string path;
};

struct TcpAddress {
    std::string host; ///< empty: the loopback interface
    std::uint16_t port = 0;
};

using Address = std::variant<UnixAddress, TcpAddress>;

/// Reads "unix:/path/of/socket", "tcp://host:port", "tcp://[IPv6]:port" or
/// "tcp://:port".
/// @throws InputError that names the text and the forms allowed
Address parseAddress(const std::string& text);

} // namespace tokay::channel
