// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel/printable.hpp"

#include <cstddef>

namespace tokay::channel {
namespace {

unsigned char byteAt(const std::string& text, std::size_t place) {
    return place < text.size() ? static_cast<unsigned char>(text[place]) : 0;
}

/// Number of bytes that the first byte of a character announces; 0 if none does
/// begin with it.
std::size_t announcedLength(unsigned char first) {
    if (first < 0x80) {
        return 1;
    }
    return first >= 0xC2 && first <= 0xDF   ? 2
           : (first & 0xF0) == 0xE0         ? 3
           : first >= 0xF0 && first <= 0xF4 ? 4
                                            : 0;
}

bool isControl(unsigned char first, unsigned char second) {
    const bool isLayout = first == '\n' || first == '\t';
    return (first < 0x20 && !isLayout) || first == 0x7F || (first == 0xC2 && second < 0xA0);
}

/// Overlong forms, halves of surrogate pairs, and what is beyond U+10FFFF.
/// Source: Unicode standard, table 3-7
bool isIllFormed(unsigned char first, unsigned char second) {
    return (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
           (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
}

/// Number of bytes of the printable character at a place; 0 if there is none.
std::size_t printableLength(const std::string& text, std::size_t place) {
    const unsigned char first = byteAt(text, place);
    const unsigned char second = byteAt(text, place + 1);
    const std::size_t length = announcedLength(first);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byteAt(text, place + i) & 0xC0) != 0x80) {
            return 0;
        }
    }
    return isControl(first, second) || isIllFormed(first, second) ? 0 : length;
}

} // namespace

std::string printable(std::string text) {
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t length = printableLength(text, place);
        if (length == 0) {
            text[place] = '?';
        }
        place += length == 0 ? 1 : length;
    }
    return text;
}

} // namespace tokay::channel
