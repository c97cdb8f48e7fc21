// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <cstddef>

namespace tokay::channel {

/// What a message must be by itself; decodePayload asks for it.
/// @throws PeerError if the name of the program is no line
void requireConsistent(const Hello& hello);

/// @throws PeerError if the arrays do not fit each other, or a number is not
///         finite or out of its range
void requireConsistent(const Interface& interface);

/// What the fluid has told of its interface, and answers have to fit.
struct Agreement {
    std::size_t nValues = 0; ///< displacement components
    double tolerance = 0;    ///< of the coupling residual
    double extent = 0;       ///< largest distance from the first point along an axis [m]

    Agreement() = default;
    explicit Agreement(const Interface& interface);
};

/// Whether a fluid may use an answer of the structure: its state is one that the
/// question allows, its numbers are as many as agreed, finite and in range.
/// @param question  BeginStep or Forces
/// @throws PeerError that says what is wrong
void requireUsable(const Displacements& answer, const Message& question,
                   const Agreement& agreement);

} // namespace tokay::channel
