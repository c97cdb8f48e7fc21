// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace tokay::tool {

enum class ByteEncoding { raw, base64 };

/// Bytes taken from a text one after the other, whether they stand there as they
/// are or as base64. White space and padding between pieces of base64 are passed.
class ByteStream {
  public:
    /// @param text  must outlive the stream
    ByteStream(std::string_view text, ByteEncoding encoding) : text_(text), encoding_(encoding) {}

    /// @throws InputError if there are fewer, or a character is not base64
    std::string take(std::size_t nBytes);

  private:
    void decodeGroup();

    std::string_view text_;
    ByteEncoding encoding_;
    std::size_t at_ = 0;
    /// Decoded but not yet taken.
    std::string decoded_;
};

} // namespace tokay::tool
