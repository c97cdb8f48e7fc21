// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/PatchNodes.hpp"

#include "igaStructure/assembly/NodePattern.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tokay::structure {

using Eigen::VectorXd;
using geometry::KnotVector;
using geometry::Points;

namespace {

constexpr double tolerance = 1e-9; // of the size of the patch, and of a weight

// Control points of the last side of a direction.
std::vector<int> lastSide(const std::vector<KnotVector>& directions, std::size_t direction) {
    int stride = 1, nControlPoints = 1;
    for (std::size_t d = 0; d < directions.size(); ++d) {
        stride *= d < direction ? directions[d].nBasis() : 1;
        nControlPoints *= directions[d].nBasis();
    }
    const int n = directions[direction].nBasis();
    std::vector<int> side;
    for (int k = 0; k < nControlPoints; ++k) {
        if (k / stride % n == n - 1) {
            side.push_back(k);
        }
    }
    return side;
}

// How far a control point of the last side is from its partner on the first one.
int distanceToPartner(const std::vector<KnotVector>& directions, std::size_t direction) {
    int stride = 1;
    for (std::size_t d = 0; d < direction; ++d) {
        stride *= directions[d].nBasis();
    }
    return stride * (directions[direction].nBasis() - 1);
}

} // namespace

PatchNodes::PatchNodes(const std::vector<KnotVector>& directions, const Points& controlPoints,
                       const VectorXd& weights, bool isSlit)
    : ofControlPoints_(controlPoints.rows()) {
    std::iota(ofControlPoints_.begin(), ofControlPoints_.end(), 0);
    const double size =
        (controlPoints.colwise().maxCoeff() - controlPoints.colwise().minCoeff()).maxCoeff();
    const auto coincide = [&](int a, int b) {
        const bool sameWeight =
            weights.size() == 0 || std::abs(weights[a] - weights[b]) <= tolerance * weights[a];
        return sameWeight &&
               (controlPoints.row(a) - controlPoints.row(b)).norm() <= tolerance * size;
    };
    for (std::size_t d = 0; d < directions.size() && !isSlit; ++d) {
        const std::vector<int> side = lastSide(directions, d);
        const int distance = distanceToPartner(directions, d);
        const bool isClosed =
            std::all_of(side.begin(), side.end(), [&](int k) { return coincide(k, k - distance); });
        if (isClosed) {
            closedDirections_.push_back(static_cast<int>(d));
            for (const int k : side) {
                ofControlPoints_[k] = ofControlPoints_[k - distance];
            }
        }
    }
    // A partner has a lower index, so its node is known.
    for (int k = 0; k < nControlPoints(); ++k) {
        if (ofControlPoints_[k] == k) {
            ofControlPoints_[k] = count();
            firstControlPoints_.push_back(k);
        } else {
            ofControlPoints_[k] = ofControlPoints_[ofControlPoints_[k]];
        }
    }
}

std::vector<int> PatchNodes::of(const std::vector<int>& controlPoints) const {
    std::vector<int> nodes;
    nodes.reserve(controlPoints.size());
    for (const int k : controlPoints) {
        nodes.push_back(of(k));
    }
    return nodes;
}

std::string PatchNodes::description() const {
    constexpr const char* names[] = {"xi", "eta", "zeta"};
    std::string text;
    for (const int direction : closedDirections_) {
        text += std::string(", closed along ") + names[direction];
    }
    return text;
}

std::vector<std::vector<int>>
PatchNodes::neighbours(const std::vector<KnotVector>& directions) const {
    std::vector<std::vector<int>> ofControlPoints = tensorNeighbours(directions);
    if (closedDirections_.empty()) {
        return ofControlPoints;
    }
    std::vector<std::vector<int>> neighbours(count());
    for (int k = 0; k < nControlPoints(); ++k) {
        const std::vector<int> own = of(ofControlPoints[k]);
        neighbours[of(k)].insert(neighbours[of(k)].end(), own.begin(), own.end());
    }
    return neighbours;
}

VectorXd PatchNodes::toControlPoints(const VectorXd& values) const {
    const Eigen::Index n = values.size() / count();
    VectorXd result(n * nControlPoints());
    for (int k = 0; k < nControlPoints(); ++k) {
        result.segment(n * k, n) = values.segment(n * of(k), n);
    }
    return result;
}

VectorXd PatchNodes::toNodes(const VectorXd& values) const {
    const Eigen::Index n = values.size() / nControlPoints();
    VectorXd result = VectorXd::Zero(n * count());
    for (int k = 0; k < nControlPoints(); ++k) {
        result.segment(n * of(k), n) += values.segment(n * k, n);
    }
    return result;
}

std::vector<bool> PatchNodes::fixed(const std::vector<bool>& fixed) const {
    const auto n = static_cast<int>(fixed.size()) / nControlPoints();
    std::vector<bool> result(static_cast<std::size_t>(n) * count(), false);
    for (int k = 0; k < nControlPoints(); ++k) {
        for (int c = 0; c < n; ++c) {
            result[n * of(k) + c] = result[n * of(k) + c] || fixed[n * k + c];
        }
    }
    return result;
}

} // namespace tokay::structure
