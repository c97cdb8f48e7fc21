// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/Channel.hpp"

#include <functional>
#include <memory>
#include <string>

namespace tokay::channel {

/// Waits for a fluid to attach (structure side).
class Listener {
  public:
    /// @param address  "unix:/path" or "tcp://host:port"; no host: loopback
    ///                 only; port 0: any free one
    /// @param token    the shared secret that the handshake will ask for
    /// @throws InputError if the address is malformed or cannot be bound, or
    ///         if it is a TCP address and the token is empty
    explicit Listener(const std::string& address, const std::string& token = "");
    ~Listener();
    Listener(Listener&&) noexcept;

    /// The address that a peer can connect to, with the actual port.
    std::string address() const;

    /// Waits for one connection.
    Channel accept();

    /// As Channel::reportSilence, while nobody attaches.
    void reportSilence(double intervalSeconds, std::function<void(const std::string&)> report);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::channel
