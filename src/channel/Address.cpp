// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/Address.hpp"

#include "common/errors.hpp"

#include <sys/un.h>

#include <algorithm>

namespace tokay::channel {
namespace {

const std::string unixPrefix = "unix:";
const std::string tcpPrefix = "tcp://";

bool startsWith(const std::string& text, const std::string& prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

[[noreturn]] void throwMalformed(const std::string& text, const std::string& reason) {
    throw InputError("The address \"" + text + "\" " + reason +
                     ". Write \"unix:/path/of/socket\" or \"tcp://host:port\".");
}

UnixAddress parseUnix(const std::string& text) {
    const std::string path = text.substr(unixPrefix.size());
    const std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
    if (path.empty()) {
        throwMalformed(text, "has no path");
    }
    if (path.size() > longest) {
        throwMalformed(text, "has a path of " + std::to_string(path.size()) +
                                 " characters, of which a socket allows " +
                                 std::to_string(longest));
    }
    return {path};
}

std::uint16_t parsePort(const std::string& text, const std::string& digits) {
    const bool isNumber =
        !digits.empty() && digits.size() <= 5 &&
        std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!isNumber || std::stoul(digits) > 65535) {
        throwMalformed(text, "has no port between 0 and 65535 behind its last colon");
    }
    return static_cast<std::uint16_t>(std::stoul(digits));
}

TcpAddress parseTcp(const std::string& text) {
    const std::string rest = text.substr(tcpPrefix.size());
    const std::size_t colon = rest.rfind(':');
    if (colon == std::string::npos) {
        throwMalformed(text, "has no port");
    }
    std::string host = rest.substr(0, colon);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
        host = host.substr(1, host.size() - 2);
    } else if (host.find(':') != std::string::npos) {
        throwMalformed(text, "has a host with colons; put an IPv6 address in brackets");
    }
    return {host, parsePort(text, rest.substr(colon + 1))};
}

} // namespace

Address parseAddress(const std::string& text) {
    if (startsWith(text, unixPrefix)) {
        return parseUnix(text);
    }
    if (startsWith(text, tcpPrefix)) {
        return parseTcp(text);
    }
    throwMalformed(text, "begins neither with \"unix:\" nor with \"tcp://\"");
}

} // namespace tokay::channel
