// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace tokay::channel {

/// Terminology
///   fluid      the flow solver's side: sends forces, receives displacements
///   structure  the structural solver's side: maps, solves, accelerates, decides
///   step       one time step; a step has several exchanges
///   exchange   forces to the structure, displacements back
///   dimension  2: points and forces have two components, forces are per unit
///              depth [N/m]; 3: three components, forces in [N]

/// Version of the messages below; both sides must agree.
constexpr std::uint32_t protocolVersion = 5;

/// Sides of a connection. A structure whose edges another one moves has the part of the fluid.
enum class Role : std::uint8_t { fluid, structure, movedStructure };

/// Random bytes, others in each handshake.
using Nonce = std::array<std::uint8_t, 32>;

/// First message of each side.
struct Hello {
    std::uint32_t protocol = protocolVersion;
    Role role = Role::fluid;
    std::string program;    ///< name and version of the sender, for messages; one line
    std::string caseDigest; ///< digest of the case file read (structure), or empty
    Nonce nonce{};          ///< challenge to the other side's Proof
};

/// Second message of each side: shows that it knows the shared token, which is
/// never sent.
struct Proof {
    std::array<std::uint8_t, 32> digest{}; ///< see proofOf
};

/// The fluid's side of the interface in its reference configuration.
struct Interface {
    std::uint32_t dimension = 3;
    std::string name;                       ///< of the coupling, for messages
    std::vector<double> points;             ///< nPoints x dimension, row by row [m]
    std::vector<std::uint32_t> faceOffsets; ///< nFaces + 1, into facePoints
    /// Point numbers, face by face; the normal points out of the fluid (2D: the
    /// fluid lies left of the edge from the first point to the second).
    std::vector<std::uint32_t> facePoints;
    std::vector<double> displacements; ///< at the start, as points [m]
    double tolerance = 0;              ///< that the residual must fall below; 1: explicit
    double startTime = 0;              ///< [s]
    double endTime = 0;                ///< [s]
    double deltaT = 0;                 ///< of the first step, about [s]
    bool retries = false;              ///< a rejected step is tried again, shorter
    bool audit = false;                ///< wants an InterfaceBalance with each accepted step
};

/// The structure can start: what it will model and how well the two sides fit.
struct Accepted {
    std::string report;       ///< several lines of text
    bool limitsForce = false; ///< the residual includes the change of force between iterations
};

/// A new time step; answered by the predicted displacements.
struct BeginStep {
    std::uint32_t step = 0;
    double time = 0;   ///< at the end of the step [s]
    double deltaT = 0; ///< [s]
};

/// Forces on the faces; answered by displacements.
struct Forces {
    bool final = false; ///< last exchange of the step: accept, do not move on
    bool write = false; ///< the fluid writes its fields at this time (with final)
    /// Initial residual of the momentum equation, if one is solved; 0: forces are exact.
    std::optional<double> fluidResidual{};
    std::vector<double> values; ///< nFaces x dimension [N], per unit depth in 2D [N/m]
    /// With final: a solution above the tolerance is not accepted; the answer is that of
    /// a coupling iteration, and the step goes on.
    bool ifConverged = false;
    /// With write, if the fluid removes old times (purgeWrite): those that it has
    /// on disk now [s]; otherwise empty.
    std::vector<double> fluidTimes{};
};

/// What has to be the same on both sides of the interface at the end of a step;
/// a plane scene: per unit depth, and a moment along z only.
struct InterfaceBalance {
    std::array<double, 3> force{};  ///< of the fluid on the structure [N]
    std::array<double, 3> moment{}; ///< about the origin [N m]
    double power = 0;               ///< force times motion in the step, over its length [W]
    double sweptVolume = 0;         ///< by the interface in the step, out of the fluid [m^3]
};

/// Its numbers in their order on the wire.
template <class Balance>
auto numbersOf(Balance& b) {
    return std::tie(b.force[0], b.force[1], b.force[2], b.moment[0], b.moment[1], b.moment[2],
                    b.power, b.sweptVolume);
}

/// The step has failed; it begins again with a shorter BeginStep. No answer.
struct RejectStep {
    std::string reason;
};

/// rejected: the structure found no solution, the step has to be rejected.
enum class State : std::uint8_t { iterate, converged, accepted, rejected };

/// Displacements of the interface points for the next exchange.
struct Displacements {
    State state = State::iterate;
    double residual = 1;                       ///< converged when below Interface::tolerance
    std::vector<double> values;                ///< nPoints x dimension [m]; empty if rejected
    std::string reason{};                      ///< why rejected
    std::optional<InterfaceBalance> balance{}; ///< of an accepted step, if asked for
};

/// The sender ends the run in good order.
struct Goodbye {
    std::string reason;
};

/// The sender cannot go on; the receiver reports the text and ends too.
struct Failure {
    std::string text;
};

using Message = std::variant<Hello, Interface, Accepted, BeginStep, Forces, Displacements, Goodbye,
                             Failure, RejectStep, Proof>;

} // namespace tokay::channel
