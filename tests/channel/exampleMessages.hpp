// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"

#include <limits>
#include <vector>

namespace tokay::channel {

/// Two triangles in the plane z = 0 that share an edge.
inline Interface exampleInterface() {
    Interface interface;
    interface.dimension = 3;
    interface.name = "flap";
    interface.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    interface.faceOffsets = {0, 3, 6};
    interface.facePoints = {0, 1, 2, 0, 2, 3};
    interface.displacements = std::vector<double>(12, -0.25);
    interface.tolerance = 1e-4;
    interface.startTime = 0.5;
    interface.endTime = 5;
    interface.deltaT = 1e-3;
    interface.retries = true;
    interface.audit = true;
    return interface;
}

/// One message of each type, every field different from its default.
inline std::vector<Message> exampleMessages() {
    return {Hello{protocolVersion, Role::structure, "igaStructure 0.1", "a3f8", {9, 8, 7}},
            exampleInterface(),
            Accepted{"coverage 100 %\nlargest gap 1e-9 m", true},
            BeginStep{12, 0.75, 1e-3},
            Forces{true,
                   true,
                   3e-5,
                   {1, -2.5, std::numeric_limits<double>::denorm_min(), -0.0},
                   true,
                   {0.25, 0.5}},
            Displacements{State::rejected,
                          2e-5,
                          {0.1, 0.2},
                          "no equilibrium",
                          InterfaceBalance{{1, 2, 3}, {4, 5, 6}, 7, 8}},
            Goodbye{"end time reached"},
            Failure{"the mesh has a cell of negative volume"},
            RejectStep{"not converged"},
            Proof{{1, 2, 3}}};
}

} // namespace tokay::channel
