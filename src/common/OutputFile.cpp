// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/OutputFile.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace tokay {

OutputFile::OutputFile(const std::string& path)
    : path_(path), temporaryPath_(path + ".part"), file_(nullptr, &std::fclose) {
    const std::filesystem::path directory = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!directory.empty() && !std::filesystem::create_directories(directory, error) && error) {
        errno = error.value();
        fail(directory.string());
    }
    file_.reset(std::fopen(temporaryPath_.c_str(), "wb"));
    if (!file_) {
        fail(temporaryPath_);
    }
}

OutputFile::~OutputFile() {
    if (!published_) {
        file_.reset();
        std::remove(temporaryPath_.c_str());
    }
}

void OutputFile::write(const void* data, std::size_t size) {
    if (std::fwrite(data, 1, size, file_.get()) != size) {
        fail(path_);
    }
}

void OutputFile::flush() {
    if (std::fflush(file_.get()) != 0) {
        fail(path_);
    }
}

void OutputFile::publish() {
    flush();
    // Some file systems report a full disk only now.
    if (fsync(fileno(file_.get())) != 0 ||
        std::rename(temporaryPath_.c_str(), path_.c_str()) != 0) {
        fail(path_);
    }
    published_ = true;
}

void OutputFile::fail(const std::string& path) const {
    throw OutputError("cannot write '" + path + "': " + std::strerror(errno));
}

} // namespace tokay
