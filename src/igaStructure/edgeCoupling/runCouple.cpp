// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/edgeCoupling/runCouple.hpp"

#include "channel/PeerError.hpp"
#include "channel/handshake/readToken.hpp"
#include "channel/handshake/shakeHands.hpp"
#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/coupledRun/CoupledRun.hpp"
#include "igaStructure/coupledRun/restart/StartState.hpp"
#include "igaStructure/edgeCoupling/EdgeSession.hpp"
#include "igaStructure/edgeCoupling/PartnerThread.hpp"
#include "igaStructure/run/describeModel.hpp"

#include <fmt/format.h>

#include <optional>
#include <sstream>

namespace tokay::structure {

namespace {

/// The cases of the two sides.
struct CoupledPair {
    Case loaded;
    Case moved;
};

CoupledPair readPair(const std::vector<std::string>& files) {
    Case first = readCoupledCase(files[0]);
    Case second = readCoupledCase(files[1]);
    if (first.coupling->side == second.coupling->side) {
        const bool isDirichlet = first.coupling->side == CouplingSide::dirichlet;
        throw second.coupling->error(
            "side", fmt::format("both structures are the {} side ({} too): one takes displacements "
                                "(side: dirichlet), the other one forces (side: neumann, the "
                                "default)",
                                isDirichlet ? "dirichlet" : "neumann", first.file));
    }
    if (first.coupling->side == CouplingSide::dirichlet) {
        std::swap(first, second);
    }
    if (!second.timeSteps) {
        throw InputError(second.file +
                         ": time: entries 'step' and 'end' are missing: the dirichlet "
                         "side leads the coupled run");
    }
    return {std::move(first), std::move(second)};
}

std::unique_ptr<const mapper::CurveInterface> edgesOf(const Case& side, const Body& body) {
    return side.coupling->at("interface", [&] { return body.edges(side.coupling->interface); });
}

void requireSameDimension(const CoupledPair& pair, const Body& loaded, const Body& moved) {
    if (loaded.dimension() != moved.dimension()) {
        throw InputError(fmt::format("{} is a structure in {}D and {} in {}D: only structures of "
                                     "one dimension can be coupled",
                                     pair.loaded.file, loaded.dimension(), pair.moved.file,
                                     moved.dimension()));
    }
}

std::string describeTraces(const CoupledPair& pair, const mapper::EdgeQuadrature& edge,
                           const MovedEdgesModel& model) {
    std::string text = fmt::format("coupled edges: {} of {}, moved by {} of {}\n"
                                   "  {} quadrature points, largest gap {:.3g} m\n",
                                   fmt::join(pair.moved.coupling->interface, " "), pair.moved.name,
                                   fmt::join(pair.loaded.coupling->interface, " "),
                                   pair.loaded.name, edge.nPoints(), edge.largestGap());
    for (int c = 0; c < model.nComponents(); ++c) {
        if (const auto& trace = model.trace(c)) {
            text +=
                fmt::format("  {}: M_DD {} x {}, rank {}{}, condition on the range {:.4g}\n",
                            "xyz"[c], trace -> basis().rows(), trace->basis().cols(), trace->rank(),
                            trace->isSingular() ? " (singular: equilibrium decides on what the "
                                                  "edge does not determine)"
                                                : "",
                            trace->conditionOnRange());
        } else {
            text += fmt::format("  {}: held by supports\n", "xyz"[c]);
        }
    }
    return text;
}

std::string describeMassMatrix(const mapper::EdgeQuadrature& edge) {
    const Eigen::MatrixXd mass = edge.massMatrix();
    std::string text = "M_DD [m], by control points of the moved edges\n";
    for (Eigen::Index i = 0; i < mass.rows(); ++i) {
        for (Eigen::Index j = 0; j < mass.cols(); ++j) {
            text += fmt::format(" {:>11.6g}", mass(i, j));
        }
        text += "\n";
    }
    return text;
}

/// A log whose lines say whose they are.
Report labelled(const std::string& name, const Report& report) {
    return [name, report](const std::string& text) {
        std::string lines;
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);) {
            lines += fmt::format("{}: {}\n", name, line);
        }
        report(lines);
    };
}

channel::Hello movedGreeting() {
    channel::Hello hello = structureGreeting();
    hello.role = channel::Role::movedStructure;
    return hello;
}

channel::Channel connect(const CoupleOptions& options) {
    channel::Channel channel = channel::Channel::connect(options.address);
    channel::shakeHands(channel, movedGreeting(),
                        options.tokenFile.empty() ? "" : channel::readToken(options.tokenFile));
    return channel;
}

// The moved structure's saved state to go on from.
SavedState startState(const Case& moved, int nUnknowns, double time) {
    const StateFolder folder = stateFolder(moved);
    constexpr double tolerance = 0.1; // of a step: names of states have few digits
    std::optional<SavedState> saved = folder.find(time, tolerance * moved.timeSteps->step);
    if (!saved) {
        const std::vector<double> times = folder.times();
        throw InputError(fmt::format(
            "--restart {:g}: {} has no saved state of that time in {}; it "
            "has: {}. States are saved where results are written "
            "(output.interval)",
            time, moved.name, folder.directory(),
            times.empty() ? "none" : fmt::format("{:.9g} s", fmt::join(times, " s, "))));
    }
    if (saved->motion.time > moved.timeSteps->end - 0.5 * moved.timeSteps->step) {
        throw InputError(
            fmt::format("--restart {:g}: the run ends there; set time.end in {} beyond "
                        "it",
                        time, moved.file));
    }
    requireSameStructure(*saved, moved, nUnknowns);
    return *std::move(saved);
}

} // namespace

void runCouple(const CoupleOptions& options, const Report& report) {
    const CoupledPair pair = readPair(options.caseFiles);
    const std::unique_ptr<Body> loaded = makeBody(pair.loaded);
    const std::unique_ptr<Body> body = makeBody(pair.moved);
    requireSameDimension(pair, *loaded, *body);
    const auto edges = edgesOf(pair.moved, *body);
    const mapper::EdgeQuadrature edge(*edgesOf(pair.loaded, *loaded), *edges,
                                      {pair.moved.coupling->gapLimit, true});
    MovedStructure moved(pair.moved, *body, *edges, edge);
    std::optional<SavedState> start;
    if (options.restartTime) {
        start = startState(pair.moved, body->model().nUnknowns(), *options.restartTime);
        moved.restore(start->motion, start->energies);
    }
    report(describeModel(pair.moved, *body) + describeTraces(pair, edge, moved.model()) +
           (options.printsMassMatrix ? describeMassMatrix(edge) : ""));

    std::optional<PartnerThread> partner;
    if (options.address.empty()) {
        partner.emplace(pair.loaded.file, labelled(pair.loaded.name, report));
    }
    constexpr double silenceInterval = 60;
    FluidLink link(partner ? partner->takeChannel() : connect(options), silenceInterval, report);
    try {
        link.shakeHands(movedGreeting());
        EdgeSession(pair.moved, *body, moved, start, edge, link, report).run();
    } catch (const channel::PeerFailure&) {
        throw; // it has ended already
    } catch (const std::exception& error) {
        link.tellFailure(error.what());
        throw;
    }
}

} // namespace tokay::structure
