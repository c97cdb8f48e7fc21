// SPDX-License-Identifier: GPL-3.0-or-later
#include "abortNotifier.H"
#include "channel/encoding.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>

#include <sys/socket.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A signal, its prepared messages, and the previous handler
struct notice
{
    int signal;
    std::string line;   // empty where OpenFOAM or the library reports it
    tokay::channel::Bytes frame;
    struct sigaction before;
};

std::array<notice, 5> notices;

//- Sockets to structures, one for each coupling of this process
std::array<std::atomic<int>, 16> sockets;

//- Number of abortNotifier objects
int nNotices = 0;

//- Whether this process is connected to a structure: the master
bool hasStructure()
{
    for (const std::atomic<int>& socket : sockets)
    {
        if (socket >= 0)
        {
            return true;
        }
    }
    return false;
}

//- Send a frame to all structures. Async-signal-safe
void notifyStructures(const tokay::channel::Bytes& frame)
{
    for (const std::atomic<int>& socket : sockets)
    {
        if (socket >= 0)
        {
            send
            (
                socket, frame.data(), frame.size(), MSG_DONTWAIT | MSG_NOSIGNAL
            );
        }
    }
}

//- Signal handler: report, then call the previous handler
extern "C" void notify(const int signal)
{
    const int error = errno;
    for (const notice& n : notices)
    {
        if (n.signal != signal)
        {
            continue;
        }
        if (signal == SIGFPE || hasStructure())
        {
            const ssize_t ignored =
                write(STDERR_FILENO, n.line.data(), n.line.size());
            static_cast<void>(ignored);
        }
        notifyStructures(n.frame);
        sigaction(signal, &n.before, nullptr);
        raise(signal);
    }
    errno = error;
}

void notifyOfExit()
{
    notifyStructures
    (
        tokay::channel::encodeFrame
        (
            tokay::channel::Failure
            {
                "it was stopped by an error of its own. See its log"
            }
        )
    );
}

//- Prepare the messages of a signal and install the handler
void install
(
    notice& n,
    const int signal,
    const std::string& what,
    const bool reports
)
{
    n.signal = signal;
    if (reports)
    {
        n.line =
            "\nstructureCoupling: the run ends here: it was " + what + '\n';
    }
    n.frame =
        tokay::channel::encodeFrame
        (
            tokay::channel::Failure{"it was " + what}
        );

    sigaction(signal, nullptr, &n.before);
    if (n.before.sa_handler == SIG_IGN)
    {
        return;
    }
    struct sigaction action = {};
    action.sa_handler = notify;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

//- Restore the previous handler, unless ours has been replaced
void uninstall(const notice& n)
{
    struct sigaction now;
    sigaction(n.signal, nullptr, &now);
    if (now.sa_handler == notify)
    {
        sigaction(n.signal, &n.before, nullptr);
    }
}

void installAll()
{
    static bool first = true;
    if (first)
    {
        std::atexit(notifyOfExit);
        first = false;
    }
    for (std::atomic<int>& socket : sockets)
    {
        socket = -1;
    }
    install(notices[0], SIGINT, "interrupted (SIGINT, Ctrl-C)", true);
    install(notices[1], SIGTERM, "terminated (SIGTERM)", true);
    install
    (
        notices[2],
        SIGFPE,
        "stopped by a floating point exception (SIGFPE): a division by zero, "
        "an overflow or an undefined number. Most often the flow has "
        "diverged: reduce deltaT, or check the mesh",
        true
    );
    const std::string error("stopped by an error of its own. See its log");
    install(notices[3], SIGABRT, error, false);
    install(notices[4], SIGSEGV, error, false);
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::abortNotifier::abortNotifier(const int socket)
:
    socket_(socket)
{
    if (nNotices++ == 0)
    {
        installAll();
    }
    for (std::atomic<int>& place : sockets)
    {
        if (socket_ >= 0 && place < 0)
        {
            place = socket_;
            break;
        }
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::abortNotifier::~abortNotifier()
{
    for (std::atomic<int>& place : sockets)
    {
        if (socket_ >= 0 && place == socket_)
        {
            place = -1;
        }
    }
    if (--nNotices == 0)
    {
        for (const notice& n : notices)
        {
            uninstall(n);
        }
    }
}


// ************************************************************************* //
