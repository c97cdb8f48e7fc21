// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace tokay::channel {

/// Waits for a fluid to attach (structure side). Strangers end nothing and hold up
/// nobody: who does not prove in time that it knows the token is refused, and any
/// number of connections may be at it at once.
class Listener {
  public:
    /// How strangers are dealt with.
    struct Patience {
        double handshakeSeconds = 10;  ///< that a handshake may take
        std::size_t maxVisitors = 256; ///< at once; beyond, the oldest is dismissed
    };

    /// @param address  "unix:/path" or "tcp://host:port"; no host: loopback
    ///                 only; port 0: any free one
    /// @param token    the shared secret that a fluid has to know
    /// @throws InputError if the address is malformed or cannot be bound, or
    ///         if it is a TCP address and the token is empty
    explicit Listener(const std::string& address, const std::string& token = "");
    Listener(const std::string& address, const std::string& token, const Patience& patience);
    ~Listener();
    Listener(Listener&&) noexcept;

    /// The address that a peer can connect to, with the actual port.
    std::string address() const;

    /// Waits for a fluid that passes the handshake.
    /// @param own  this side's greeting
    /// @return     a trusted channel
    Channel accept(const Hello& own);

    /// As Channel::reportSilence, until a fluid has attached.
    void reportSilence(double intervalSeconds, std::function<void(const std::string&)> report);

    /// Called with one line for each connection that is refused, up to a number
    /// that a log can bear.
    void reportRefusals(std::function<void(const std::string&)> report);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::channel
