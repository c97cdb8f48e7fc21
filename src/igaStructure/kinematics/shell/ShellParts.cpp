// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/ShellParts.hpp"

#include "igaStructure/assembly/RigidMotions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tokay::structure {

namespace {

// Faces that joints connect.
struct ShellPart {
    std::vector<int> faces;
    std::string name; // "patch a", "patches a, b and 3 more"
};

std::vector<ShellPart> shellParts(const geometry::BrepModel& model) {
    std::vector<int> lowest(model.faces().size()); // face of each one's part
    std::iota(lowest.begin(), lowest.end(), 0);
    for (const geometry::BrepEdge& edge : model.edges()) {
        for (const geometry::BrepTrim& trim : edge.trims) {
            const int from = std::max(lowest[trim.face], lowest[edge.trims[0].face]);
            const int to = std::min(lowest[trim.face], lowest[edge.trims[0].face]);
            std::replace(lowest.begin(), lowest.end(), from, to);
        }
    }
    std::vector<ShellPart> parts;
    for (std::size_t k = 0; k < lowest.size(); ++k) {
        if (lowest[k] == static_cast<int>(k)) {
            parts.emplace_back();
        }
    }
    std::map<int, std::size_t> partOf;
    for (std::size_t face = 0; face < lowest.size(); ++face) {
        const std::size_t part = partOf.try_emplace(lowest[face], partOf.size()).first->second;
        parts[part].faces.push_back(static_cast<int>(face));
    }
    for (ShellPart& part : parts) {
        constexpr std::size_t nNamed = 5;
        std::vector<std::string> names;
        for (std::size_t k = 0; k < std::min(nNamed, part.faces.size()); ++k) {
            names.push_back(model.patch(part.faces[k]).name());
        }
        part.name = fmt::format(
            "patch{} {}{}", part.faces.size() == 1 ? "" : "es", fmt::join(names, ", "),
            part.faces.size() > nNamed ? fmt::format(" and {} more", part.faces.size() - nNamed)
                                       : "");
    }
    return parts;
}

std::vector<int> nodesOf(const ShellPart& part, const ShellNodes& shell) {
    std::vector<int> nodes;
    for (const int face : part.faces) {
        nodes.insert(nodes.end(), shell.ofFace[face].begin(), shell.ofFace[face].end());
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

// What the support of an edge holds, if it belongs to a part of the shell.
void holdEdge(const TrimmedSupport& support, const std::vector<int>& nodes, RigidMotions& motions) {
    for (const EdgePoint& point : support.points) {
        const PatchLocation& at = point.side;
        if (!std::binary_search(nodes.begin(), nodes.end(), at.nodes.front())) {
            continue;
        }
        for (int c = 0; c < 3; ++c) {
            if (support.fixed[c]) {
                motions.holdPoint(at.position, Eigen::Vector3d::Unit(c));
            }
        }
        if (support.clamped) {
            motions.holdRotation((at.baseVectors * at.tangent).normalized());
        }
    }
}

// Rigid motions of some nodes, ascending, that neither fixed unknowns nor couplings prevent.
std::vector<std::string> motionsOf(const std::vector<int>& nodes, const geometry::Points& positions,
                                   const ShellConstraints& constraints) {
    RigidMotions motions(positions(nodes, Eigen::all));
    for (const int node : nodes) {
        for (int c = 0; c < 3; ++c) {
            if (constraints.supported[3 * static_cast<std::size_t>(node) + c]) {
                motions.hold(motions.at(positions.row(node)).row(c));
            }
        }
    }
    for (const auto& coupling : constraints.couplings) {
        if (!std::binary_search(nodes.begin(), nodes.end(), coupling->nodes().front())) {
            continue;
        }
        const Eigen::MatrixXd rows = coupling->restRows();
        Eigen::MatrixXd own(rows.cols(), 6);
        for (std::size_t k = 0; k < coupling->nodes().size(); ++k) {
            own.middleRows<3>(3 * static_cast<Eigen::Index>(k)) =
                motions.at(positions.row(coupling->nodes()[k]));
        }
        motions.hold(rows * own / std::sqrt(1e-300 + rows.squaredNorm()));
    }
    for (const TrimmedSupport& support : constraints.trimmedSupports) {
        holdEdge(support, nodes, motions);
    }
    return motions.freeOnes();
}

} // namespace

std::vector<std::string> freeRigidMotions(const ShellDescription& description,
                                          const ShellNodes& nodes,
                                          const ShellConstraints& constraints) {
    const std::vector<ShellPart> parts = shellParts(description.model);
    if (parts.size() == 1) {
        return motionsOf(nodesOf(parts[0], nodes), nodes.positions, constraints);
    }
    std::vector<std::string> all;
    for (const ShellPart& part : parts) {
        for (const std::string& motion :
             motionsOf(nodesOf(part, nodes), nodes.positions, constraints)) {
            all.push_back(fmt::format("{} of {}", motion, part.name));
        }
    }
    return all;
}

std::vector<std::string> looseParts(const ShellDescription& description, const ShellNodes& nodes,
                                    const ShellConstraints& constraints) {
    const std::vector<ShellPart> parts = shellParts(description.model);
    std::vector<std::string> loose;
    for (const ShellPart& part : parts) {
        const std::size_t allRigidMotions = description.isPlane ? 3 : 6;
        if (parts.size() > 1 &&
            motionsOf(nodesOf(part, nodes), nodes.positions, constraints).size() ==
                allRigidMotions) {
            loose.push_back(part.name);
        }
    }
    return loose;
}

} // namespace tokay::structure
