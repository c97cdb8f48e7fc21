// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/ResultsLock.hpp"

#include "common/OutputFile.hpp"
#include "common/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace tokay::structure {

namespace {

std::string thisProcess() {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    return fmt::format("process {} on {}", getpid(), host.data());
}

[[noreturn]] void throwUnwritable(const std::string& path, int error) {
    throw OutputError("cannot write '" + path + "': " + std::strerror(error));
}

} // namespace

ResultsLock::ResultsLock(const std::string& directory, const std::string& name,
                         const Report& report)
    : directory_(directory), path_(directory + "/" + name + ".lock") {
    std::error_code error;
    if (!std::filesystem::create_directories(directory, error) && error) {
        throwUnwritable(directory, error.value());
    }
    try {
        lock(report);
        writeHolder();
    } catch (...) {
        close(file_);
        throw;
    }
}

ResultsLock::~ResultsLock() {
    unlink(path_.c_str()); // while it is locked, so that nobody loses a lock of his own
    close(file_);
    rmdir(directory_.c_str());
}

void ResultsLock::lock(const Report& report) {
    do {
        open();
        if (!tryToLock()) {
            throw InputError(fmt::format(
                "'{}' is in use: {} writes results there; wait for its end, stop it, or choose "
                "another output.directory",
                directory_, holder()));
        }
    } while (!isStillThere());
    if (const std::string before = holder(); !before.empty()) {
        report(fmt::format("note: {} has left '{}' without an end (was it killed?); its lock is "
                           "taken over\n",
                           before, directory_));
    }
}

void ResultsLock::open() {
    if (file_ >= 0) {
        close(file_);
    }
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) {
        throwUnwritable(path_, errno);
    }
}

// File systems that know no locks cannot refuse one.
bool ResultsLock::tryToLock() {
    return flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

// A holder that ends removes the file, perhaps after it was opened here.
bool ResultsLock::isStillThere() const {
    struct stat opened;
    struct stat named;
    return fstat(file_, &opened) == 0 && stat(path_.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

std::string ResultsLock::holder() const {
    std::array<char, 300> text{};
    const ssize_t size = pread(file_, text.data(), text.size(), 0);
    return {text.data(), static_cast<std::size_t>(size > 0 ? size : 0)};
}

void ResultsLock::writeHolder() {
    const std::string text = thisProcess();
    if (ftruncate(file_, 0) != 0 ||
        pwrite(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
        throwUnwritable(path_, errno);
    }
}

} // namespace tokay::structure
