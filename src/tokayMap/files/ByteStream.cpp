// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/ByteStream.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::tool {

namespace {

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') {
        return c - 'A';
    }
    if (c >= 'a' && c <= 'z') {
        return c - 'a' + 26;
    }
    if (c >= '0' && c <= '9') {
        return c - '0' + 52;
    }
    if (c == '+') {
        return 62;
    }
    return c == '/' ? 63 : -1;
}

bool isSpace(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

} // namespace

std::string ByteStream::take(std::size_t nBytes) {
    const std::size_t left = text_.size() - at_;
    const std::size_t most = encoding_ == ByteEncoding::raw ? left : decoded_.size() + left / 4 * 3;
    if (nBytes > most) {
        throw InputError(
            fmt::format("{} bytes are announced, {} are left: the file is cut off", nBytes, most));
    }
    if (encoding_ == ByteEncoding::raw) {
        at_ += nBytes;
        return std::string(text_.substr(at_ - nBytes, nBytes));
    }
    while (decoded_.size() < nBytes) {
        decodeGroup();
    }
    std::string bytes = decoded_.substr(0, nBytes);
    decoded_.erase(0, nBytes);
    return bytes;
}

void ByteStream::decodeGroup() {
    unsigned bits = 0;
    int nDigits = 0, nPadding = 0;
    while (nDigits + nPadding < 4) {
        if (at_ == text_.size()) {
            throw InputError("base64 data end too early: the file is cut off");
        }
        const char c = text_[at_++];
        if (isSpace(c)) {
            continue;
        }
        const int digit = base64Digit(c);
        if (c == '=') {
            ++nPadding;
        } else if (digit < 0 || nPadding > 0) {
            throw InputError(fmt::format("'{}' is not a character of base64 here", c));
        } else {
            ++nDigits;
        }
        bits = bits << 6 | static_cast<unsigned>(digit < 0 ? 0 : digit);
    }
    for (int i = 0; i + 1 < nDigits; ++i) {
        decoded_ += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
    }
}

} // namespace tokay::tool
