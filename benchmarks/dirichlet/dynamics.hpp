// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay::structure {

/// The membrane with inertia and a solution that jumps,
///   u = sin(pi x) cos(pi y) (1 + tanh(1e4 (t - 0.01))),
/// on all edges: a row an integration in time and a method.
/// Source: Camarotti's data, but for the 1, without which a body at rest would be displaced
void writeDynamics(const std::string& file);

} // namespace tokay::structure
