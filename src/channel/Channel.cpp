// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/Channel.hpp"

#include "channel/Address.hpp"
#include "channel/encoding.hpp"
#include "channel/waitReporting.hpp"
#include "common/errors.hpp"

#include <asio/connect.hpp>
#include <asio/generic/stream_protocol.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/local/stream_protocol.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <fcntl.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <optional>

namespace tokay::channel {

struct Channel::Implementation {
    asio::io_context context;
    asio::generic::stream_protocol::socket socket{context};
    SilenceReport silence;
    std::string peer = "the peer";
    std::uint32_t limit = largestPayloadOfStranger;

    asio::error_code read(void* data, std::size_t size, const std::string& waitingFor);
    asio::error_code write(const Bytes& frame, const SilenceReport& reporting);
    Message receive(const std::string& waitingFor);
    Bytes readPayload(std::uint32_t size, const std::string& waitingFor);
    void throwIfBroken(asio::error_code error, const std::string& waitingFor) const;

  private:
    void finish(const std::optional<asio::error_code>& result, const SilenceReport& reporting,
                const std::string& waitingFor);
};

namespace {

int domainOf(int fileDescriptor) {
    int domain = 0;
    int type = 0;
    sockaddr_storage peerAddress;
    socklen_t size = sizeof(int);
    socklen_t addressSize = sizeof peerAddress;
    const bool isConnectedStream =
        getsockopt(fileDescriptor, SOL_SOCKET, SO_DOMAIN, &domain, &size) == 0 &&
        getsockopt(fileDescriptor, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_STREAM &&
        getpeername(fileDescriptor, reinterpret_cast<sockaddr*>(&peerAddress), &addressSize) == 0;
    if (!isConnectedStream) {
        throw InputError("File descriptor " + std::to_string(fileDescriptor) +
                         " is no connected stream socket: the channel to the peer needs one.");
    }
    return domain;
}

void setSocketOptions(int fileDescriptor, int domain) {
    fcntl(fileDescriptor, F_SETFD, FD_CLOEXEC);
    if (domain == AF_UNIX) {
        return;
    }
    const auto set = [fileDescriptor](int level, int option, int value) {
        setsockopt(fileDescriptor, level, option, &value, sizeof value);
    };
    set(IPPROTO_TCP, TCP_NODELAY, 1);
    // A machine that vanishes without a word is noticed within a minute.
    set(SOL_SOCKET, SO_KEEPALIVE, 1);
    set(IPPROTO_TCP, TCP_KEEPIDLE, 20);
    set(IPPROTO_TCP, TCP_KEEPINTVL, 10);
    set(IPPROTO_TCP, TCP_KEEPCNT, 4);
}

int connectedSocket(const UnixAddress& address) {
    asio::io_context context;
    asio::local::stream_protocol::socket socket(context);
    socket.connect(asio::local::stream_protocol::endpoint(address.path));
    return socket.release();
}

int connectedSocket(const TcpAddress& address) {
    asio::io_context context;
    asio::ip::tcp::socket socket(context);
    asio::ip::tcp::resolver resolver(context);
    const std::string host = address.host.empty() ? "localhost" : address.host;
    asio::connect(socket, resolver.resolve(host, std::to_string(address.port)));
    return socket.release();
}

} // namespace

Channel::Channel(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
Channel::Channel(Channel&&) noexcept = default;
Channel& Channel::operator=(Channel&&) noexcept = default;
Channel::~Channel() = default;

Channel Channel::fromFileDescriptor(int fileDescriptor) {
    const int domain = domainOf(fileDescriptor);
    setSocketOptions(fileDescriptor, domain);
    auto implementation = std::make_unique<Implementation>();
    implementation->socket.assign(asio::generic::stream_protocol(domain, 0), fileDescriptor);
    return Channel(std::move(implementation));
}

Channel Channel::connect(const std::string& address) {
    const Address parsed = parseAddress(address);
    try {
        return fromFileDescriptor(
            std::visit([](const auto& where) { return connectedSocket(where); }, parsed));
    } catch (const std::system_error& error) {
        throw PeerError("nobody answers at \"" + address + "\" (" + error.code().message() +
                        "): start the structure first, with the same address");
    }
}

void Channel::Implementation::finish(const std::optional<asio::error_code>& result,
                                     const SilenceReport& reporting,
                                     const std::string& waitingFor) {
    try {
        waitReporting(context, reporting, waitingFor, [&result] { return result.has_value(); });
    } catch (...) {
        // The operation still refers to buffers of the caller: end it first.
        socket.close();
        context.restart();
        context.run();
        throw;
    }
}

asio::error_code Channel::Implementation::read(void* data, std::size_t size,
                                               const std::string& waitingFor) {
    std::optional<asio::error_code> result;
    asio::async_read(socket, asio::buffer(data, size),
                     [&result](asio::error_code error, std::size_t) { result = error; });
    finish(result, silence, waitingFor);
    return *result;
}

asio::error_code Channel::Implementation::write(const Bytes& frame,
                                                const SilenceReport& reporting) {
    std::optional<asio::error_code> result;
    asio::async_write(socket, asio::buffer(frame),
                      [&result](asio::error_code error, std::size_t) { result = error; });
    finish(result, reporting, peer + " to take a message");
    return *result;
}

void Channel::Implementation::throwIfBroken(asio::error_code error,
                                            const std::string& waitingFor) const {
    if (error == asio::error::eof || error == asio::error::connection_reset ||
        error == asio::error::broken_pipe) {
        throw PeerError(peer + " ended without saying why, while this side waited for " +
                        waitingFor);
    }
    if (error) {
        throw PeerError("the connection to " + peer + " broke (" + error.message() +
                        "), while this side waited for " + waitingFor);
    }
}

Bytes Channel::Implementation::readPayload(std::uint32_t size, const std::string& waitingFor) {
    // Grown as bytes arrive: a false length alone makes us allocate nothing.
    constexpr std::size_t portion = 1u << 20;
    Bytes payload;
    while (payload.size() < size) {
        const std::size_t have = payload.size();
        payload.resize(have + std::min<std::size_t>(size - have, std::max(portion, have)));
        throwIfBroken(read(payload.data() + have, payload.size() - have, waitingFor), waitingFor);
    }
    return payload;
}

Message Channel::Implementation::receive(const std::string& waitingFor) {
    std::array<std::uint8_t, FrameHeader::size> bytes;
    throwIfBroken(read(bytes.data(), bytes.size(), waitingFor), waitingFor);
    try {
        const FrameHeader header = decodeHeader(bytes, limit);
        return decodePayload(header, readPayload(header.payloadLength, waitingFor));
    } catch (const PeerError& error) {
        throw PeerError("from " + peer + ": " + error.what());
    }
}

Message Channel::receive(const std::string& waitingFor) {
    Message message = implementation_->receive(waitingFor);
    if (const auto* failure = std::get_if<Failure>(&message)) {
        throw PeerFailure(peer() + " ended: " + failure->text);
    }
    return message;
}

void Channel::send(const Message& message) {
    const asio::error_code error =
        implementation_->write(encodeFrame(message), implementation_->silence);
    if (!error) {
        return;
    }
    // A peer that is gone may have said why; its last words are still here.
    const std::string waitingFor = peer() + " to take a message";
    try {
        while (true) {
            receive(waitingFor);
        }
    } catch (const PeerFailure&) {
        throw;
    } catch (const PeerError&) {
        implementation_->throwIfBroken(error, waitingFor);
    }
}

bool Channel::trySend(const Message& message) noexcept {
    try {
        const SilenceReport giveUp = {2.0, [](const std::string& text) { throw PeerError(text); }};
        return !implementation_->write(encodeFrame(message), giveUp);
    } catch (...) {
        return false;
    }
}

void Channel::reportSilence(double intervalSeconds,
                            std::function<void(const std::string&)> report) {
    implementation_->silence = {intervalSeconds, std::move(report)};
}

const std::string& Channel::peer() const {
    return implementation_->peer;
}

int Channel::fileDescriptor() const {
    return implementation_->socket.native_handle();
}

void Channel::trust(const std::string& peer) {
    implementation_->peer = peer;
    implementation_->limit = largestPayload;
}

bool Channel::isTrusted() const {
    return implementation_->limit == largestPayload;
}

void Channel::throwUnexpected(const Message& message, const std::string& waitingFor) {
    if (const auto* goodbye = std::get_if<Goodbye>(&message)) {
        throw PeerError(peer() + " said goodbye (" + goodbye->reason +
                        ") while this side waited for " + waitingFor);
    }
    throw PeerError(peer() + " sent a message of type " + typeName(message.index()) +
                    " while this side waited for " + waitingFor);
}

} // namespace tokay::channel
