// SPDX-License-Identifier: GPL-3.0-or-later
#include "endNotice.H"
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

//- A signal: what is said of it, ready for use, and who handled it before
struct notice
{
    int signal;
    std::string line;   // empty where others say it: OpenFOAM, the library
    tokay::channel::Bytes frame;
    struct sigaction before;
};

std::array<notice, 5> notices;

//- Sockets to structures, one for each coupling of this process
std::array<std::atomic<int>, 16> sockets;

//- Number of objects
int nNotices = 0;

//- Whether this process is the one that speaks for all ranks
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

//- Calls only what a signal handler may call
void tellStructures(const tokay::channel::Bytes& frame)
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

//- Likewise
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
        tellStructures(n.frame);
        sigaction(signal, &n.before, nullptr);
        raise(signal);
    }
    errno = error;
}

void notifyOfExit()
{
    tellStructures
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

//- Words for a signal, and the handler in its place
void install
(
    notice& n,
    const int signal,
    const std::string& what,
    const bool speaks
)
{
    n.signal = signal;
    if (speaks)
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

//- The handlers of before, where they have not been replaced since
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

Foam::endNotice::endNotice(const int socket)
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

Foam::endNotice::~endNotice()
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
