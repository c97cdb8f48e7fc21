// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/PeerError.hpp"
#include "channel/messages.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace tokay::channel {

/// One connection to the peer, carrying whole messages in both directions.
///
/// A frame is: magic (4 bytes), protocol version, type, payload length (all
/// uint32, little-endian), payload. Lengths are checked before anything is
/// allocated. No call raises SIGPIPE.
class Channel {
  public:
    /// Takes over a connected stream socket, e.g. one end of a socket pair;
    /// it is not inherited by programs started later.
    /// @throws InputError if it is no connected stream socket
    static Channel fromFileDescriptor(int fileDescriptor);

    /// Attaches to a listening structure.
    /// @param address  "unix:/path/of/socket" or "tcp://host:port"
    /// @throws InputError if the address is malformed, PeerError if nobody answers
    static Channel connect(const std::string& address);

    Channel(Channel&&) noexcept;
    Channel& operator=(Channel&&) noexcept;
    ~Channel();

    /// @throws PeerError if the peer is gone, with the peer's own text if it
    ///         sent a Failure before; InputError if the message is too large
    void send(const Message& message);

    /// Tries to tell the peer something on the way out: gives up after two
    /// seconds and never throws.
    /// @return  whether the message was handed over
    bool trySend(const Message& message) noexcept;

    /// Waits for the next message. A silent peer is reported, not given up.
    /// @param waitingFor  completes "waiting for …", e.g. "the fluid's forces, step 12"
    /// @throws PeerError at end of stream or on a frame that is not ours,
    ///         PeerFailure with the peer's own text if the message is a Failure
    Message receive(const std::string& waitingFor);

    /// As receive, and the message must be of one type.
    /// @throws PeerError also if it is another
    template <class Expected>
    Expected receive(const std::string& waitingFor) {
        Message message = receive(waitingFor);
        if (auto* expected = std::get_if<Expected>(&message)) {
            return std::move(*expected);
        }
        throwUnexpected(message, waitingFor);
    }

    /// Called with one line of text ("waiting for the fluid's forces since
    /// 60 s, step 12") each time the peer has been silent for another interval
    /// while this side waits. An exception thrown by it ends the wait and
    /// closes the channel.
    /// @param intervalSeconds  positive, or 0: never
    void reportSilence(double intervalSeconds, std::function<void(const std::string&)> report);

    /// "the fluid", "the structure", or "the peer" before the handshake.
    const std::string& peer() const;

    /// The socket, for a signal handler, which may call nothing of this class.
    int fileDescriptor() const;

    /// Names the peer in messages from now on, and allows it frames of any
    /// type's full size; called when a handshake is complete.
    void trust(const std::string& peer);

    /// Whether a handshake has been completed.
    bool isTrusted() const;

  private:
    struct Implementation;
    explicit Channel(std::unique_ptr<Implementation>);
    [[noreturn]] void throwUnexpected(const Message&, const std::string& waitingFor);

    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay::channel
