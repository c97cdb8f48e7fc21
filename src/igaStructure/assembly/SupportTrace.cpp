// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/SupportTrace.hpp"

#include <cassert>

namespace tokay::structure {

using Eigen::VectorXd;

SupportTrace::SupportTrace(std::vector<SupportPoint> points, const std::vector<bool>& moving,
                           int nComponents)
    : points_(std::move(points)), nComponents_(nComponents), numbers_(moving.size(), -1) {
    for (std::size_t k = 0; k < moving.size(); ++k) {
        if (moving[k]) {
            numbers_[k] = static_cast<int>(unknowns_.size());
            unknowns_.push_back(static_cast<int>(k));
        }
    }
    if (isEmpty()) {
        return;
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const SupportPoint& point : points_) {
        for (int c = 0; c < nComponents_; ++c) {
            forEachUnknown(point, c, [&](int row, double N) {
                forEachUnknown(point, c, [&](int column, double M) {
                    entries.emplace_back(row, column, point.weight * N * M);
                });
            });
        }
    }
    const auto n = static_cast<Eigen::Index>(unknowns_.size());
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    matrix_ = std::make_shared<Eigen::SimplicialLDLT<SparseMatrix>>(matrix);
    assert(matrix_->info() == Eigen::Success);
}

template <class Visit>
void SupportTrace::forEachUnknown(const SupportPoint& point, int component, Visit visit) const {
    if (!point.components[component]) {
        return;
    }
    for (std::size_t k = 0; k < point.nodes.size(); ++k) {
        const int number = numbers_[nComponents_ * point.nodes[k] + component];
        if (number >= 0) {
            visit(number, point.N[static_cast<Eigen::Index>(k)]);
        }
    }
}

VectorXd SupportTrace::at(double time) const {
    VectorXd all = VectorXd::Zero(static_cast<Eigen::Index>(numbers_.size()));
    if (!isEmpty()) {
        all(unknowns_) = latest_.at(time, [&] { return fitted(time); });
    }
    return all;
}

VectorXd SupportTrace::fitted(double time) const {
    VectorXd moments = VectorXd::Zero(static_cast<Eigen::Index>(unknowns_.size()));
    for (const SupportPoint& point : points_) {
        const Eigen::Vector3d motion = point.motion->value(point.position, time);
        for (int c = 0; c < nComponents_; ++c) {
            forEachUnknown(point, c, [&](int number, double N) {
                moments[number] += point.weight * N * motion[c];
            });
        }
    }
    return matrix_->solve(moments);
}

} // namespace tokay::structure
