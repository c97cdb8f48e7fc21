#pragma once

#include "coupling/messages.hpp"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace tokay::coupling {

/// The peer is gone, talks nonsense, or reported a failure of its own.
class PeerError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// One connection to the peer, carrying whole messages in both directions.
///
/// A frame is: magic (4 bytes), protocol version, type, payload length (all
/// uint32, little-endian), payload. Lengths are checked before anything is
/// allocated.
class Channel {
  public:
    /// Takes over a connected stream socket, e.g. one end of a socket pair.
    static Channel fromFileDescriptor(int fileDescriptor);

    /// Attaches to a listening structure.
    /// @param address  "unix:/path/of/socket" or "tcp://host:port"
    /// @throws InputError if the address is malformed, PeerError if nobody answers
    static Channel connect(const std::string& address);

    Channel(Channel&&) noexcept;
    Channel& operator=(Channel&&) noexcept;
    ~Channel();

    /// @throws PeerError if the peer is gone
    void send(const Message& message);

    /// Waits for the next message. A silent peer is reported, not given up.
    /// @param waitingFor  completes "waiting for …", e.g. "the fluid's forces, step 12"
    /// @throws PeerError at end of stream, on a frame that is not ours, and
    ///         with the peer's own text if the message is a Failure
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

    /// Called with one line of text each time the peer has been silent for
    /// another interval while this side waits.
    void reportSilence(double intervalSeconds,
                       std::function<void(const std::string&)> report);

  private:
    struct Implementation;
    explicit Channel(std::unique_ptr<Implementation>);
    [[noreturn]] void throwUnexpected(const Message&, const std::string& waitingFor);

    std::unique_ptr<Implementation> implementation_;
};

/// Waits for a fluid to attach (structure side).
/// @param address  "unix:/path" or "tcp://host:port" (port 0: any free one)
class Listener {
  public:
    explicit Listener(const std::string& address);
    ~Listener();
    /// The address that a peer can connect to, with the actual port.
    std::string address() const;
    Channel accept();

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Exchanges Hello messages and checks protocol version, role and token.
/// @return  the peer's Hello
/// @throws  PeerError that names both versions, or the wrong token
Hello shakeHands(Channel& channel, const Hello& own);

} // namespace tokay::coupling
