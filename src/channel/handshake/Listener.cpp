// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/handshake/Listener.hpp"

#include "channel/Address.hpp"
#include "channel/handshake/Visitor.hpp"
#include "channel/waitReporting.hpp"
#include "common/errors.hpp"

#include <asio/basic_socket_acceptor.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/local/datagram_protocol.hpp>
#include <asio/local/stream_protocol.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>

namespace tokay::channel {

using Acceptor = asio::basic_socket_acceptor<asio::generic::stream_protocol>;

namespace {

// A log with more lines would be the stranger's.
constexpr int maxRefusalReports = 20;

} // namespace

struct Listener::Implementation {
    asio::io_context context;
    std::optional<Acceptor> acceptor;
    std::string address;
    std::string socketFile; ///< removed at the end; empty for TCP
    std::string token;
    Patience patience;
    SilenceReport silence;
    std::function<void(const std::string&)> reportRefusal = [](const std::string&) {};

    Hello greeting;
    std::deque<std::weak_ptr<Visitor>> visitors; ///< the oldest first
    std::optional<Channel> accepted;
    std::optional<asio::error_code> failure;
    int nRefusals = 0;

    void listen(const UnixAddress&);
    void listen(const TcpAddress&);
    void acceptNext();
    void receive(Visitor::Socket socket);
    bool dismissOldest();
    void judge(Visitor& visitor, const std::string& refusal);
    void take(Visitor& visitor);
    void wait();

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

void Listener::Implementation::acceptNext() {
    acceptor->async_accept([this](asio::error_code error, Visitor::Socket socket) {
        if (error == asio::error::operation_aborted) {
            return;
        }
        if (!error) {
            receive(std::move(socket));
        } else if (!dismissOldest()) { // or there are no file descriptors left
            failure = error;
            return;
        }
        acceptNext();
    });
}

void Listener::Implementation::receive(Visitor::Socket socket) {
    const auto isGone = [](const std::weak_ptr<Visitor>& visitor) { return visitor.expired(); };
    visitors.erase(std::remove_if(visitors.begin(), visitors.end(), isGone), visitors.end());
    if (visitors.size() >= patience.maxVisitors) {
        dismissOldest();
    }
    const auto visitor = std::make_shared<Visitor>(
        std::move(socket), Handshake(greeting, token),
        [this](Visitor& who, const std::string& refusal) { judge(who, refusal); });
    visitors.push_back(visitor);
    visitor->receive(patience.handshakeSeconds);
}

bool Listener::Implementation::dismissOldest() {
    while (!visitors.empty()) {
        const std::shared_ptr<Visitor> oldest = visitors.front().lock();
        visitors.pop_front();
        if (oldest) {
            oldest->dismiss("too many others came");
            return true;
        }
    }
    return false;
}

void Listener::Implementation::take(Visitor& visitor) {
    const int fileDescriptor = visitor.release();
    try {
        accepted = Channel::fromFileDescriptor(fileDescriptor);
        accepted->trust(visitor.handshake().peerName());
    } catch (const InputError&) { // it has ended since
        close(fileDescriptor);
        judge(visitor, "it ended after the handshake");
    }
}

void Listener::Implementation::judge(Visitor& visitor, const std::string& refusal) {
    if (refusal.empty()) {
        take(visitor);
        return;
    }
    if (++nRefusals <= maxRefusalReports) {
        reportRefusal("refused " + visitor.origin() + ": " + refusal);
    }
    if (nRefusals == maxRefusalReports) {
        reportRefusal("further refusals are not reported");
    }
}

/// Until a fluid is accepted; reports at intervals, however busy strangers keep it.
void Listener::Implementation::wait() {
    using Clock = std::chrono::steady_clock;
    const auto interval = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(silence.intervalSeconds));
    const auto start = Clock::now();
    auto next = start + interval;
    while (!accepted && !failure) {
        if (silence.intervalSeconds <= 0) {
            context.run_one();
            continue;
        }
        context.run_one_until(next);
        if (Clock::now() >= next) {
            next = Clock::now() + interval;
            const std::chrono::duration<double> waited = Clock::now() - start;
            silence.report(silenceText("a fluid to attach at " + address, waited.count()));
        }
    }
}

Listener::Listener(const std::string& address, const std::string& token)
    : Listener(address, token, Patience()) {}

Listener::Listener(const std::string& address, const std::string& token, const Patience& patience)
    : implementation_(std::make_unique<Implementation>()) {
    implementation_->token = token;
    implementation_->patience = patience;
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

void Listener::reportRefusals(std::function<void(const std::string&)> report) {
    implementation_->reportRefusal = std::move(report);
}

Channel Listener::accept(const Hello& own) {
    Implementation& here = *implementation_;
    here.greeting = own;
    here.failure.reset();
    here.accepted.reset();
    here.context.restart();
    here.acceptNext();
    try {
        here.wait();
    } catch (...) {
        here.acceptor->cancel();
        throw;
    }
    if (here.failure) {
        throw PeerError("no fluid could attach at \"" + address() + "\" (" +
                        here.failure->message() + ")");
    }
    here.acceptor->cancel();
    return std::move(*here.accepted);
}

} // namespace tokay::channel
