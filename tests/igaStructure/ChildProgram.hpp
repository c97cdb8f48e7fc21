// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporaryDirectory.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tokay::structure {

/// igaStructure as a child process; its output goes to a file.
class ChildProgram {
  public:
    /// @param socket  becomes the child's file descriptor 3; -1: none
    explicit ChildProgram(std::vector<std::string> arguments, int socket = -1) {
        arguments.insert(arguments.begin(), TOKAY_IGA_STRUCTURE);
        pid_ = fork();
        if (pid_ == 0) {
            execute(arguments, socket);
        }
    }
    ~ChildProgram() {
        if (!status_) {
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
    }
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    void signal(int number) const { kill(pid_, number); }

    /// Exit status; 1000 + signal if one killed it; -1 if it runs on too long.
    int wait(double seconds = 10) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!status_ && std::chrono::steady_clock::now() < end) {
            int status = 0;
            if (waitpid(pid_, &status, WNOHANG) == pid_) {
                status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
            } else {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
        return status_.value_or(-1);
    }

    std::string output() const { return directory_.read("output"); }

    /// Waits until the output has a text.
    bool waitForOutput(const std::string& text, double seconds = 10) const {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (output().find(text) == std::string::npos) {
            if (std::chrono::steady_clock::now() > end) {
                return false;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return true;
    }

  private:
    [[noreturn]] void execute(const std::vector<std::string>& arguments, int socket) const {
        std::vector<char*> words;
        for (const std::string& argument : arguments) {
            words.push_back(const_cast<char*>(argument.c_str()));
        }
        words.push_back(nullptr);
        const int output = open(directory_.file("output").c_str(), O_WRONLY | O_CREAT, 0666);
        dup2(output, STDOUT_FILENO);
        dup2(output, STDERR_FILENO);
        if (socket >= 0) {
            dup2(socket, 3);
        }
        execv(words[0], words.data());
        _exit(127);
    }

    TemporaryDirectory directory_;
    pid_t pid_;
    std::optional<int> status_;
};

} // namespace tokay::structure
