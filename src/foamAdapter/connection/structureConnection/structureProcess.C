// SPDX-License-Identifier: GPL-3.0-or-later
#include "structureProcess.H"
#include "common/errors.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The child's end of the socket pair, by this number
constexpr int childFileDescriptor = 3;

//- This process's environment for the structure, whose threads are not to spin
//  on the fluid's processors while they wait for each other
//  \param passive  the entry that says so
std::vector<char*> ownEnvironment(std::string& passive)
{
    std::vector<char*> entries;
    for (char** entry = environ; *entry; ++entry)
    {
        entries.push_back(*entry);
    }
    if (!std::getenv("OMP_WAIT_POLICY"))
    {
        entries.push_back(&passive[0]);
    }
    entries.push_back(nullptr);
    return entries;
}

//- Start the program with the socket and the log in place of its own files
int spawn
(
    const std::string& program,
    const std::vector<std::string>& arguments,
    const std::string& logFile,
    const int socket,
    int& pid
)
{
    std::vector<std::string> words(arguments);
    words.insert(words.begin(), program);
    words.push_back("--channel-fd");
    words.push_back(std::to_string(childFileDescriptor));

    std::vector<char*> argv;
    for (std::string& word : words)
    {
        argv.push_back(&word[0]);
    }
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen
    (
        &actions,
        STDOUT_FILENO,
        logFile.c_str(),
        O_WRONLY | O_CREAT | O_TRUNC,
        0666
    );
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, socket, childFileDescriptor);

    std::string passive("OMP_WAIT_POLICY=passive");
    std::vector<char*> environment(ownEnvironment(passive));
    const int error =
        posix_spawnp
        (
            &pid,
            program.c_str(),
            &actions,
            nullptr,
            argv.data(),
            environment.data()
        );
    posix_spawn_file_actions_destroy(&actions);

    return error;
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::structureProcess::waitForEnd(const double seconds)
{
    using clock = std::chrono::steady_clock;
    const auto deadline = clock::now() + std::chrono::duration<double>(seconds);

    while (pid_ > 0)
    {
        const int ended = waitpid(pid_, &status_, WNOHANG);
        if (ended == pid_ || (ended < 0 && errno != EINTR))
        {
            pid_ = -1;
        }
        else if (clock::now() > deadline)
        {
            return false;
        }
        else
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::structureProcess::structureProcess
(
    const std::string& program,
    const std::vector<std::string>& arguments,
    const std::string& logFile
)
:
    pid_(-1),
    fileDescriptor_(-1),
    logFile_(logFile),
    status_(0)
{
    // The log is opened by the child: find out here whether it can be
    const int log = open(logFile.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (log < 0)
    {
        throw tokay::InputError
        (
            "the structure's log '" + logFile + "' cannot be written: "
          + std::strerror(errno)
          + ". Does the folder of the entry 'case' exist?"
        );
    }
    close(log);

    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    {
        throw tokay::InputError
        (
            std::string("no socket for the structure: ") + std::strerror(errno)
        );
    }

    const int error = spawn(program, arguments, logFile, ends[1], pid_);
    close(ends[1]);
    fileDescriptor_ = ends[0];

    if (error)
    {
        pid_ = -1;
        close(fileDescriptor_);
        throw tokay::InputError
        (
            "the structure's program '" + program + "' cannot be started: "
          + std::strerror(error)
          + ". Source Tokay's bin/environment, or name the program by the "
            "entry 'program'"
        );
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::structureProcess::~structureProcess()
{
    if (fileDescriptor_ >= 0)
    {
        close(fileDescriptor_);
    }
    end(5);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::structureProcess::takeFileDescriptor()
{
    const int taken = fileDescriptor_;
    fileDescriptor_ = -1;
    return taken;
}


std::string Foam::structureProcess::end(const double seconds)
{
    std::string how;
    if (!waitForEnd(seconds))
    {
        kill(pid_, SIGKILL);
        waitForEnd(seconds);
        how = "did not end by itself and was killed";
    }
    else if (WIFSIGNALED(status_))
    {
        how =
            "was ended by signal " + std::to_string(WTERMSIG(status_))
          + " (" + strsignal(WTERMSIG(status_)) + ")";
    }
    else if (WEXITSTATUS(status_) != 0)
    {
        how = "ended with status " + std::to_string(WEXITSTATUS(status_));
    }

    return how.empty()
      ? how
      : "the structure " + how + "; its log: " + logFile_;
}


// ************************************************************************* //
