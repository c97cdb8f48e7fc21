// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/Listener.hpp"

#include "channel/Address.hpp"
#include "channel/waitReporting.hpp"
#include "common/errors.hpp"

#include <asio/basic_socket_acceptor.hpp>
#include <asio/generic/stream_protocol.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/local/datagram_protocol.hpp>
#include <asio/local/stream_protocol.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <optional>

namespace tokay::channel {

using Acceptor = asio::basic_socket_acceptor<asio::generic::stream_protocol>;

struct Listener::Implementation {
    asio::io_context context;
    std::optional<Acceptor> acceptor;
    std::string address;
    std::string socketFile; ///< removed at the end; empty for TCP
    SilenceReport silence;

    void listen(const UnixAddress&);
    void listen(const TcpAddress&);

    ~Implementation() {
        if (!socketFile.empty()) {
            unlink(socketFile.c_str());
        }
    }
};

namespace {

bool isSocket(const std::string& path) {
    struct stat status;
    return lstat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode);
}

/// Removes the socket that a killed structure left behind, nothing else. The
/// probe is a datagram socket: a listening stream socket refuses its type and
/// is not disturbed, an abandoned one refuses the connection.
void removeAbandonedSocket(const std::string& path) {
    if (!isSocket(path)) {
        return;
    }
    asio::io_context context;
    asio::local::datagram_protocol::socket probe(context);
    asio::error_code error;
    probe.connect(asio::local::datagram_protocol::endpoint(path), error);
    if (error == asio::error::connection_refused) {
        unlink(path.c_str());
    }
}

std::string tcpText(const asio::ip::tcp::endpoint& endpoint) {
    const std::string host = endpoint.address().to_string();
    return "tcp://" + (endpoint.address().is_v6() ? "[" + host + "]" : host) + ":" +
           std::to_string(endpoint.port());
}

} // namespace

void Listener::Implementation::listen(const UnixAddress& where) {
    removeAbandonedSocket(where.path);
    asio::local::stream_protocol::acceptor local(context);
    local.open();
    // Only this user may attach; set before anyone can.
    const mode_t mask = umask(0177);
    asio::error_code error;
    local.bind(asio::local::stream_protocol::endpoint(where.path), error);
    umask(mask);
    asio::detail::throw_error(error);
    socketFile = where.path;
    local.listen();
    address = "unix:" + where.path;
    acceptor.emplace(std::move(local));
}

void Listener::Implementation::listen(const TcpAddress& where) {
    asio::ip::tcp::resolver resolver(context);
    const std::string host = where.host.empty() ? "127.0.0.1" : where.host;
    const asio::ip::tcp::endpoint endpoint =
        resolver.resolve(host, std::to_string(where.port), asio::ip::tcp::resolver::passive)
            .begin()
            ->endpoint();
    asio::ip::tcp::acceptor tcp(context, endpoint);
    address = tcpText(tcp.local_endpoint());
    acceptor.emplace(std::move(tcp));
}

Listener::Listener(const std::string& address, const std::string& token)
    : implementation_(std::make_unique<Implementation>()) {
    const Address parsed = parseAddress(address);
    if (std::holds_alternative<TcpAddress>(parsed) && token.empty()) {
        throw InputError("Listening at \"" + address +
                         "\" needs a token, because anyone on that network could attach: give "
                         "both sides the same secret.");
    }
    try {
        std::visit([this](const auto& where) { implementation_->listen(where); }, parsed);
    } catch (const std::system_error& error) {
        throw InputError("Cannot listen at \"" + address + "\" (" + error.code().message() +
                         "): choose another address.");
    }
}

Listener::~Listener() = default;
Listener::Listener(Listener&&) noexcept = default;

std::string Listener::address() const {
    return implementation_->address;
}

void Listener::reportSilence(double intervalSeconds,
                             std::function<void(const std::string&)> report) {
    implementation_->silence = {intervalSeconds, std::move(report)};
}

Channel Listener::accept() {
    auto& context = implementation_->context;
    asio::generic::stream_protocol::socket socket(context);
    std::optional<asio::error_code> result;
    implementation_->acceptor->async_accept(socket,
                                            [&result](asio::error_code error) { result = error; });
    try {
        waitReporting(context, implementation_->silence, "a fluid to attach at " + address(),
                      [&result] { return result.has_value(); });
    } catch (...) {
        // The operation still refers to our socket: end it first.
        implementation_->acceptor->cancel();
        context.restart();
        context.run();
        throw;
    }
    if (*result) {
        throw PeerError("no fluid could attach at \"" + address() + "\" (" + result->message() +
                        ")");
    }
    return Channel::fromFileDescriptor(socket.release());
}

} // namespace tokay::channel
