// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace tokay {

/// A result cannot be written: no space, no permission, no directory.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file that replaces an older one of its name only when it is known to be
/// on disk: until publish() it has a temporary name. Every write is checked.
class OutputFile {
  public:
    /// Creates the directory too.
    /// @throws OutputError
    explicit OutputFile(const std::string& path);

    /// Removes the file if it was not published.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// @throws OutputError
    void write(const void* data, std::size_t size);
    void write(const std::string& text) { write(text.data(), text.size()); }

    /// Hands what was written to the system. @throws OutputError
    void flush();

    /// Flushes and takes its name; may be written to further.
    /// @throws OutputError, and then the older file is as it was
    void publish();

  private:
    [[noreturn]] void fail(const std::string& path) const;

    std::string path_;
    std::string temporaryPath_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    bool published_ = false;
};

} // namespace tokay
