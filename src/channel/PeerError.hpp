// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace tokay::channel {

/// The peer is gone, talks nonsense, or reported a failure of its own.
class PeerError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The peer said itself, by a Failure message, why it cannot go on. It has
/// ended already: do not answer by a Failure.
class PeerFailure : public PeerError {
  public:
    using PeerError::PeerError;
};

} // namespace tokay::channel
