// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/Visitor.hpp"

#include "channel/PeerError.hpp"
#include "common/errors.hpp"

#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

namespace tokay::channel {
namespace {

// For the other side to read why it is refused.
constexpr double farewellSeconds = 2;

std::string originOf(const Visitor::Socket& socket) {
    asio::error_code error;
    const auto generic = socket.remote_endpoint(error);
    asio::ip::tcp::endpoint endpoint;
    const int family = generic.protocol().family();
    if (error || (family != AF_INET && family != AF_INET6) ||
        generic.size() > endpoint.capacity()) {
        return "a connection";
    }
    std::memcpy(endpoint.data(), generic.data(), generic.size());
    return endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
}

/// What a stranger can write into our log.
std::string inOneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

Visitor::Visitor(Socket socket, Handshake handshake, Verdict verdict)
    : socket_(std::move(socket)), timer_(socket_.get_executor()), handshake_(std::move(handshake)),
      verdict_(std::move(verdict)), origin_(originOf(socket_)) {}

void Visitor::receive(double seconds) {
    std::string text = std::to_string(seconds);
    text.erase(text.find_last_not_of('0') + 1); // "10."
    text.erase(text.find_last_not_of('.') + 1);
    limitTo(seconds, "no handshake within " + text + " s");
    readHeader();
}

void Visitor::limitTo(double seconds, const std::string& reason) {
    timer_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(seconds)));
    timer_.async_wait([self = shared_from_this(), reason](asio::error_code error) {
        if (!error) {
            self->dismiss(reason);
        }
    });
}

/// Does the next part of the handshake unless the connection has ended; what it throws is why the
/// visitor is refused.
template <class Work>
void Visitor::attempt(asio::error_code error, Work work) {
    if (!socket_.is_open()) {
        return;
    }
    if (error) {
        refuse("it ended the connection before the handshake was complete", false);
        return;
    }
    try {
        work();
    } catch (const PeerFailure& failure) {
        refuse(shortened(failure.what()), false);
    } catch (const PeerError& peerError) {
        refuse(peerError.what(), true);
    }
}

void Visitor::readHeader() {
    asio::async_read(socket_, asio::buffer(headerBytes_),
                     [self = shared_from_this()](asio::error_code error, std::size_t) {
                         self->attempt(error, [&visitor = *self] {
                             visitor.header_ =
                                 decodeHeader(visitor.headerBytes_, largestPayloadOfStranger);
                             visitor.readPayload();
                         });
                     });
}

void Visitor::readPayload() {
    payload_.resize(header_.payloadLength);
    asio::async_read(socket_, asio::buffer(payload_),
                     [self = shared_from_this()](asio::error_code error, std::size_t) {
                         self->attempt(error, [&visitor = *self] { visitor.answer(); });
                     });
}

void Visitor::answer() {
    const std::optional<Message> next = handshake_.answer(decodePayload(header_, payload_));
    const auto proceed = [this] {
        if (handshake_.isComplete()) {
            timer_.cancel();
            std::exchange(verdict_, nullptr)(*this, "");
        } else {
            readHeader();
        }
    };
    if (next) {
        send(*next, proceed);
    } else {
        proceed();
    }
}

void Visitor::send(const Message& message, std::function<void()> next) {
    sent_ = encodeFrame(message);
    asio::async_write(socket_, asio::buffer(sent_),
                      [self = shared_from_this(), next = std::move(next)](
                          asio::error_code error, std::size_t) { self->attempt(error, next); });
}

void Visitor::refuse(const std::string& reason, bool tell) {
    if (!verdict_ || !tell) {
        dismiss(reason);
        return;
    }
    std::exchange(verdict_, nullptr)(*this, inOneLine(reason));
    limitTo(farewellSeconds, reason);
    send(Failure{reason}, [this] {
        asio::error_code ignored;
        socket_.shutdown(asio::socket_base::shutdown_send, ignored);
        drain();
    });
}

/// Reads what still comes: a socket that is closed with unread bytes takes back what it has sent.
void Visitor::drain() {
    payload_.resize(largestPayloadOfStranger);
    socket_.async_read_some(asio::buffer(payload_),
                            [self = shared_from_this()](asio::error_code error, std::size_t) {
                                error ? self->close() : self->drain();
                            });
}

void Visitor::dismiss(const std::string& reason) {
    close();
    if (verdict_) {
        std::exchange(verdict_, nullptr)(*this, inOneLine(reason));
    }
}

void Visitor::close() {
    asio::error_code ignored;
    timer_.cancel();
    socket_.close(ignored);
}

int Visitor::release() {
    return socket_.release();
}

} // namespace tokay::channel
