// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/encoding.hpp"
#include "channel/handshake/Handshake.hpp"

#include <asio/generic/stream_protocol.hpp>
#include <asio/steady_timer.hpp>

#include <functional>
#include <memory>
#include <string>

namespace tokay::channel {

/// Somebody who has connected to a listening structure, until the handshake has
/// shown who it is. Lives by the operations that wait for it, so that any number
/// can wait in one thread.
class Visitor : public std::enable_shared_from_this<Visitor> {
  public:
    using Socket = asio::generic::stream_protocol::socket;

    /// Called once.
    /// @param refusal  why the visitor is no fluid of ours, in one line; empty if it is
    using Verdict = std::function<void(Visitor&, const std::string& refusal)>;

    Visitor(Socket socket, Handshake handshake, Verdict verdict);

    /// Begins the handshake.
    /// @param seconds  that it may take as a whole
    void receive(double seconds);

    /// Ends it at once, without a word. A verdict that is due is given.
    void dismiss(const std::string& reason);

    /// Where the visitor comes from, for messages.
    const std::string& origin() const { return origin_; }

    const Handshake& handshake() const { return handshake_; }

    /// Hands the socket over.
    int release();

  private:
    void limitTo(double seconds, const std::string& reason);
    void readHeader();
    void readPayload();
    void answer();
    void send(const Message& message, std::function<void()> next);
    void refuse(const std::string& reason, bool tell);
    void drain();
    void close();
    template <class Work>
    void attempt(asio::error_code error, Work work);

    Socket socket_;
    asio::steady_timer timer_;
    Handshake handshake_;
    Verdict verdict_; ///< empty once given
    std::string origin_;
    std::array<std::uint8_t, FrameHeader::size> headerBytes_;
    FrameHeader header_;
    Bytes payload_;
    Bytes sent_;
};

} // namespace tokay::channel
